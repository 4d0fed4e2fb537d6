// SPDX-License-Identifier: MIT
// Rays from a surface: do they leave the mesh?
#pragma once

#include <span>
#include <vector>

#include "mesh/box_tree.h"

namespace kdm {

class Sight {
 public:
  /// Both must outlive this; triangles in `left_out` (one flag each) are not in the way.
  Sight(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
        const std::vector<char>& left_out);

  /// Whether a ray that starts on triangle `from` meets none of the others, up to infinity. What
  /// lies within 1e-7 of the mesh's size is overlooked, so faces that lie on each other are not in
  /// each other's way. Rays do not slip through between triangles that share an edge.
  bool escapes(const Vec3& origin, const Vec3& direction, Index from) const;

 private:
  std::span<const Triangle> triangles_;
  const std::vector<Vec3>& points_;
  std::vector<Index> number_;  // of the triangle in each box
  std::vector<Box> boxes_;
  BoxTree tree_;
  double nearest_ = 0;
};

/// Unit vectors evenly spread, the same on every platform; no component is 0.
std::vector<Vec3> spread_directions(Index count);

}  // namespace kdm
