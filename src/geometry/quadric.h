// SPDX-License-Identifier: MIT
// The primal quadric: squared distances to a set of planes, and where they are least
// (paper 2.2.1; P. Lindstrom, Out-of-core simplification of large polygonal models, 2000).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "geometry/plane.h"

namespace kdm {

/// E(x) = sum of (n_i . x - d_i)^2, kept about a centre near the planes.
class PrimalQuadric {
 public:
  explicit PrimalQuadric(const Vec3& centre) : centre_(centre) {}

  void add(const Plane& plane) {
    const double offset = plane.offset - plane.normal.dot(centre_);
    a_.noalias() += plane.normal * plane.normal.transpose();
    b_ += offset * plane.normal;
    c_ += offset * offset;
  }

  double error(const Vec3& x) const {
    const Vec3 y = x - centre_;
    return y.dot(a_ * y) - 2 * b_.dot(y) + c_;
  }

  /// Per coordinate, how much of it the planes determine: 1 where the minimiser's is unique, 0
  /// where it may be moved at will. Sums up to the rank.
  Vec3 certainty() const;

  /// The minimiser nearest to the centre, directions with an eigenvalue below `cutoff` of the
  /// largest left alone.
  Vec3 minimiser(double cutoff = kRankCutoff) const;

  /// The same within a box that holds the centre. If the free minimiser is outside, the least
  /// value on the box's faces, edges and corners counts (P. Lindstrom, C. Silva, A memory
  /// insensitive technique for large model simplification, 2001).
  Vec3 minimiser_in(const Vec3& lo, const Vec3& hi, double cutoff = kRankCutoff) const;

  /// The minimiser, or the point of the box nearest to it if it is outside.
  Vec3 minimiser_projected(const Vec3& lo, const Vec3& hi) const {
    return minimiser().cwiseMax(lo).cwiseMin(hi);
  }

  /// Eigenvalues are sums of squares of unit normals' parts, so this is a matter of angles alone:
  /// what counts in a leaf of any size bends the surface by a tenth of that size or more.
  /// Normals that differ by less than about 6 degrees from one plane count as that plane.
  static constexpr double kRankCutoff = 0.01;
  /// The same for half a degree: for what the coarser rank leaves out of tolerance.
  static constexpr double kFineCutoff = 1e-4;

 private:
  // How many of the eigenvalues are not below `cutoff` of the largest.
  static int rank(const Vec3& values, double cutoff);
  Vec3 boundary_minimiser(const Vec3& lo, const Vec3& hi) const;

  Vec3 centre_;
  Eigen::Matrix3d a_ = Eigen::Matrix3d::Zero();
  Vec3 b_ = Vec3::Zero();
  double c_ = 0;
};

/// A minimiser and the largest distance to its planes.
struct Minimiser {
  Vec3 point;
  double residual;
};

/// `minimiser_in` by the coarse rank if its residual, the largest distance to the planes, is well
/// within the tolerance, else by the fine one if that is nearer.
template <typename Residual>
Minimiser minimiser_within(const PrimalQuadric& quadric, const Vec3& lo, const Vec3& hi,
                           double tolerance, const Residual& residual) {
  const Vec3 coarse = quadric.minimiser_in(lo, hi);
  const double off = residual(coarse);
  if (off <= 0.5 * tolerance) return {coarse, off};
  const Vec3 fine = quadric.minimiser_in(lo, hi, PrimalQuadric::kFineCutoff);
  const double fine_off = residual(fine);
  return fine_off < off ? Minimiser{fine, fine_off} : Minimiser{coarse, off};
}

/// A point of the box within the tolerance of all planes, if one is found: weights grow where
/// planes are far until none is too far (C. L. Lawson, Contributions to the theory of linear least
/// maximum approximation, 1961). Planes that count often draw the plain minimiser away from the
/// others.
std::optional<Vec3> point_within(std::span<const Plane> planes, const Vec3& centre, const Vec3& lo,
                                 const Vec3& hi, double tolerance);

}  // namespace kdm
