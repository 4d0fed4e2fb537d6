// SPDX-License-Identifier: MIT
// The sum of squared distances to the planes of triangles, each times the triangle's area: what a
// vertex that stands for these triangles costs (M. Garland, P. Heckbert, Surface simplification
// using quadric error metrics, 1997).
#pragma once

#include <algorithm>

#include "kdmanifold/types.h"

namespace kdm {

/// The function E(x) = x . A x - 2 b . x + c. `PrimalQuadric` of grids is the same with unit
/// weights and minimisers within boxes; this one is small, and there are many.
class ErrorQuadric {
 public:
  /// Adds the plane n . x = offset, for a unit normal.
  void add_plane(const Vec3& normal, double offset, double weight) {
    const Vec3 n = weight * normal;
    xx_ += n[0] * normal[0];
    xy_ += n[0] * normal[1];
    xz_ += n[0] * normal[2];
    yy_ += n[1] * normal[1];
    yz_ += n[1] * normal[2];
    zz_ += n[2] * normal[2];
    b_ += offset * n;
    c_ += weight * offset * offset;
    weight_ += weight;
  }
  ErrorQuadric& operator+=(const ErrorQuadric& other) {
    xx_ += other.xx_;
    xy_ += other.xy_;
    xz_ += other.xz_;
    yy_ += other.yy_;
    yz_ += other.yz_;
    zz_ += other.zz_;
    b_ += other.b_;
    c_ += other.c_;
    weight_ += other.weight_;
    return *this;
  }

  /// Returns E(x), which rounding does not make negative.
  double error(const Vec3& x) const {
    return std::max(0.0, x.dot(product(x)) - 2 * b_.dot(x) + c_);
  }
  /// Returns the sum of the weights of the planes.
  double weight() const { return weight_; }

  /// Returns where E is least. Directions that the planes leave open are decided by nearness to
  /// `centre`: a very small part of the squared distance to it is added.
  Vec3 minimiser(const Vec3& centre) const {
    const double pull = kPull * (xx_ + yy_ + zz_);
    const double xx = xx_ + pull;
    const double yy = yy_ + pull;
    const double zz = zz_ + pull;
    const Vec3 b =
        b_ - product(centre);  // for the way from the centre, which is solved more exactly
    const double cxx = yy * zz - yz_ * yz_;
    const double cxy = xz_ * yz_ - xy_ * zz;
    const double cxz = xy_ * yz_ - xz_ * yy;
    const double cyy = xx * zz - xz_ * xz_;
    const double cyz = xy_ * xz_ - xx * yz_;
    const double czz = xx * yy - xy_ * xy_;
    const double determinant = xx * cxx + xy_ * cxy + xz_ * cxz;
    if (!(determinant > 0)) return centre;
    return centre + Vec3(cxx * b[0] + cxy * b[1] + cxz * b[2], cxy * b[0] + cyy * b[1] + cyz * b[2],
                         cxz * b[0] + cyz * b[1] + czz * b[2]) /
                        determinant;
  }

 private:
  Vec3 product(const Vec3& x) const {
    return {xx_ * x[0] + xy_ * x[1] + xz_ * x[2], xy_ * x[0] + yy_ * x[1] + yz_ * x[2],
            xz_ * x[0] + yz_ * x[1] + zz_ * x[2]};
  }

  static constexpr double kPull = 1e-6;

  double xx_ = 0, xy_ = 0, xz_ = 0, yy_ = 0, yz_ = 0, zz_ = 0;  // A, which is symmetric
  Vec3 b_ = Vec3::Zero();
  double c_ = 0;
  double weight_ = 0;
};

}  // namespace kdm
