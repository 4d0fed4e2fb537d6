// SPDX-License-Identifier: MIT
// Follows rays from points of a surface, to see whether they leave the mesh.
#pragma once

#include <span>
#include <vector>

#include "mesh/box_tree.h"
#include "mesh/marks.h"
#include "mesh/numbers.h"

namespace kdm {

/// Tells what can be seen from outside: which rays from the triangles of a mesh reach infinity.
class Sight {
 public:
  /// `triangles` and `points` must outlive this. The triangles marked in `left_out` stop no ray.
  Sight(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
        const Marks& left_out);

  /// Tells whether a ray that starts on triangle `from` meets no other triangle. Triangles nearer
  /// to the origin than 1e-7 of the diagonal of the mesh's box are ignored, so that faces that lie
  /// on each other do not stop each other's rays. Rays do not slip through between triangles that
  /// share an edge. Takes logarithmic time on usual meshes. No component of `direction` may be 0.
  bool escapes(const Vec3& origin, const Vec3& direction, TriangleId from) const;

  /// Returns the winding number of a closed surface just off a point of triangle `from`, on the
  /// side to which `direction` leads: how often the ray leaves through the other triangles, less
  /// how often it enters. See `escapes`.
  int winding(const Vec3& origin, const Vec3& direction, TriangleId from) const;

 private:
  std::span<const Triangle> triangles_;
  const std::vector<Vec3>& points_;
  std::vector<TriangleId> triangle_in_;  // per box
  std::vector<Box> boxes_;
  BoxTree tree_;
  double least_distance_ = 0;  // nearer triangles are overlooked
};

/// Returns unit vectors that are spread evenly over all directions, the same on every platform. No
/// component is 0.
std::vector<Vec3> spread_directions(Index count);

}  // namespace kdm
