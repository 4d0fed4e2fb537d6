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

/// Remembers what one thread has found out about the triangles round vertices.
struct TestedFans {
  Marks tested;                   // per vertex
  Marks simple;                   // per vertex that was tested
  std::vector<OuterSide> around;  // of the vertex that is looked at
};

/// Tests pairs of triangles of a mesh, with the positions that its vertices have in the result: in
/// model units, rounded to 32 bits. Several threads may test at a time, each with its own fans.
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
  /// Exact. Triangles without area meet nothing. `fans` are those of this mesh.
  bool meet(const DualMesh& mesh, const CachedTriangle& triangle, TriangleId other,
            TestedFans& fans) const;
  /// Tells whether the corners lie on one line. Exact.
  bool has_no_area(const DualMesh& mesh, TriangleId t) const;

 private:
  static Triangle corner_numbers(const DualMesh& mesh, TriangleId t) {
    return {mesh.vertex[3 * t], mesh.vertex[3 * t + 1], mesh.vertex[3 * t + 2]};
  }
  std::array<Vec3, 3> corners(const Triangle& numbers) const {
    return {rounded_positions_[numbers[0]], rounded_positions_[numbers[1]],
            rounded_positions_[numbers[2]]};
  }
  bool fan_is_simple(const DualMesh& mesh, VertexId v, TestedFans& fans) const;
  bool find_if_fan_is_simple(const DualMesh& mesh, VertexId v,
                             std::vector<OuterSide>& around) const;

  GridView view_;
  double scale_;                         // makes the largest coordinate about one
  std::vector<Vec3> rounded_positions_;  // per vertex: as in the result, times the scale
  std::vector<SmallBox> boxes_;          // per triangle
};

}  // namespace kdm
