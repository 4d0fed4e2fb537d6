// SPDX-License-Identifier: MIT
// Prepares a triangle to be tested against many others.
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "mesh/small_box.h"

namespace kdm {

/// Keeps a triangle's box and plane, which tell quickly that most other triangles do not meet it.
class CachedTriangle {
 public:
  /// `numbers` are the numbers of the corners' vertices, `corners` their positions.
  CachedTriangle(const Triangle& numbers, const std::array<Vec3, 3>& corners)
      : numbers_(numbers), corners_(corners), box_(small_box(corners[0], corners[1], corners[2])) {
    const Vec3 u = corners[1] - corners[0];
    const Vec3 v = corners[2] - corners[0];
    normal_ = u.cross(v);
    // Rounding changes `height` in `side` by some 2^-50 of these sizes and the distance at most.
    slack_ = 0x1p-46 * u.cwiseAbs().sum() * v.cwiseAbs().sum();
  }

  const Triangle& numbers() const { return numbers_; }
  const std::array<Vec3, 3>& corners() const { return corners_; }
  const SmallBox& box() const { return box_; }

  /// Returns the vertex of a corner that both triangles have, or kNone.
  Index shared_corner(const Triangle& other) const {
    for (const Index v : numbers_) {
      if (v == other[0] || v == other[1] || v == other[2]) return v;
    }
    return kNone;
  }

  /// Tells whether this triangle's plane shows that triangle (a, b, c), which shares no corner with
  /// this one, does not meet it. A false answer says nothing.
  bool surely_apart(const Vec3& a, const Vec3& b, const Vec3& c) const {
    const int first = side(a);
    return first != 0 && side(b) == first && side(c) == first;
  }

 private:
  // On which side of the plane the point lies: 1 or -1, or 0 where rounding might decide.
  int side(const Vec3& p) const {
    const Vec3 d = p - corners_[0];
    const double height = normal_.dot(d);
    const double slack = slack_ * d.cwiseAbs().maxCoeff();
    return height > slack ? 1 : (height < -slack ? -1 : 0);
  }

  Triangle numbers_;
  std::array<Vec3, 3> corners_;
  SmallBox box_;
  Vec3 normal_;
  double slack_;
};

}  // namespace kdm
