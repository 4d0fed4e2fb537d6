// SPDX-License-Identifier: MIT
// Decides exactly whether two triangles of a mesh cross or touch.
#pragma once

#include <array>
#include <vector>

#include "extract/dual/dual_mesh.h"
#include "extract/dual/grid_view.h"
#include "extract/embed/cached_triangle.h"
#include "geometry/fan.h"
#include "mesh/marks.h"
#include "mesh/small_box.h"

namespace kdm {

/// Tests pairs of triangles of a mesh, with the positions that its vertices have in the result: in
/// model units, rounded to 32 bits.
class PairTest {
 public:
  explicit PairTest(const GridView& view);

  /// Makes ready for a mesh that has changed. Positions that were read before are kept.
  void update(const DualMesh& mesh);
  /// Reads the positions of the triangle's corners. To be done before the triangle is tested, and
  /// again whenever they change.
  void read_corners(const DualMesh& mesh, TriangleId t);

  /// Returns the triangle with its corners, ready to be tested against many.
  CachedTriangle cached(const DualMesh& mesh, TriangleId t) const;
  /// Tells whether the two triangles have more in common than the corners and sides they share.
  /// Exact. Triangles without area meet nothing.
  bool meet(const DualMesh& mesh, const CachedTriangle& triangle, TriangleId other);
  /// Tells whether the corners lie on one line. Exact.
  bool has_no_area(const DualMesh& mesh, TriangleId t) const;

  /// Tells whether, seen from some direction, the triangles round the vertex lie beside each other,
  /// all turned the right way: then no two of them meet but in the vertex and the sides they share.
  /// If not, they may or may not meet. Remembers the answer until the next `update`.
  bool fan_is_simple(const DualMesh& mesh, VertexId v);

 private:
  static Triangle corner_numbers(const DualMesh& mesh, TriangleId t) {
    return {mesh.vertex[3 * t], mesh.vertex[3 * t + 1], mesh.vertex[3 * t + 2]};
  }
  std::array<Vec3, 3> corners(const Triangle& numbers) const {
    return {rounded_positions_[numbers[0]], rounded_positions_[numbers[1]],
            rounded_positions_[numbers[2]]};
  }
  bool find_if_fan_is_simple(const DualMesh& mesh, VertexId v);

  GridView view_;
  double scale_;                         // makes the largest coordinate about one
  std::vector<Vec3> rounded_positions_;  // per vertex: as in the result, times the scale
  std::vector<SmallBox> boxes_;          // per triangle
  Marks fan_was_tested_;                 // per vertex
  Marks fan_is_simple_;                  // per vertex whose fan was tested
  std::vector<OuterSide> outer_sides_;   // of the vertex that is looked at
};

}  // namespace kdm
