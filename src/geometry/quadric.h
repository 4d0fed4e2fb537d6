// SPDX-License-Identifier: MIT
// The primal quadric: the sum of the squared distances to a set of planes, and where it is least
// (paper 2.2.1; P. Lindstrom, Out-of-core simplification of large polygonal models, 2000).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "geometry/plane.h"
#include "geometry/symmetric.h"

namespace kdm {

/// The function E(x) = sum of (n_i . x - d_i)^2 over planes. It is kept relative to a centre near
/// the planes, so that little is lost to rounding.
class PrimalQuadric {
 public:
  explicit PrimalQuadric(const Vec3& centre) : centre_(centre) {}

  /// Adds a plane.
  void add(const Plane& plane) {
    const double offset = plane.offset - plane.normal.dot(centre_);
    a_.noalias() += plane.normal * plane.normal.transpose();
    b_ += offset * plane.normal;
    c_ += offset * offset;
  }

  /// Adds the planes of another one.
  void add(const PrimalQuadric& other) {
    const Vec3 shift = centre_ - other.centre_;
    const Vec3 turned = other.a_ * shift;
    a_ += other.a_;
    b_ += other.b_ - turned;
    c_ += other.c_ - 2 * other.b_.dot(shift) + shift.dot(turned);
  }

  /// Returns E(x).
  double error(const Vec3& x) const {
    const Vec3 y = x - centre_;
    return y.dot(a_ * y) - 2 * b_.dot(y) + c_;
  }

  /// Returns for each coordinate how far the planes determine it: 1 if all minimisers agree in the
  /// coordinate, 0 if it may have any value. The three numbers add up to the rank: how many
  /// directions the planes determine.
  Vec3 certainty() const;

  /// Returns the eigenvalues of E, in falling order: how well the planes determine a direction.
  Vec3 spread() const { return eigenvalues(a_); }
  /// Returns how many directions the planes determine, with the cutoff of `minimiser`.
  int rank(double cutoff) const { return rank(spread(), cutoff); }
  /// Tells whether a direction is determined by the fine cutoff, but not by the usual one. `spread`
  /// must be that of this quadric.
  static bool is_blurred(const Vec3& spread) {
    return rank(spread, kRankCutoff) < rank(spread, kFineCutoff);
  }

  /// Returns a point at which E is least; of several the one nearest to the centre. Directions
  /// whose eigenvalue is at most `cutoff` times the largest count as undetermined.
  Vec3 minimiser(double cutoff = kRankCutoff) const { return minimiser(spread(), cutoff); }
  /// The same; `spread` must be that of this quadric.
  Vec3 minimiser(const Vec3& spread, double cutoff) const;

  /// Returns a point of the box at which E is least. The box must hold the centre. If `minimiser`
  /// is outside the box, the least value on the box's faces, edges and corners counts (P.
  /// Lindstrom, C. Silva, A memory insensitive technique for large model simplification, 2001).
  Vec3 minimiser_in(const Vec3& lo, const Vec3& hi, double cutoff = kRankCutoff) const {
    return minimiser_in(spread(), lo, hi, cutoff);
  }
  /// The same; `spread` must be that of this quadric.
  Vec3 minimiser_in(const Vec3& spread, const Vec3& lo, const Vec3& hi, double cutoff) const;

  /// Returns `minimiser`, or the point of the box nearest to it if it is outside the box.
  Vec3 minimiser_projected(const Vec3& lo, const Vec3& hi) const {
    return minimiser().cwiseMax(lo).cwiseMin(hi);
  }

  /// The usual cutoff. Eigenvalues are sums of squares of components of unit normals, so it depends
  /// on angles alone: normals that differ from a common one by less than about 6 degrees count as
  /// one plane. So in a leaf of any size, a surface counts as bent if it leaves a plane by about a
  /// tenth of the leaf's size.
  static constexpr double kRankCutoff = 0.01;
  /// A cutoff that corresponds to half a degree, for where the usual one misses the tolerance.
  static constexpr double kFineCutoff = 1e-4;

 private:
  // Returns how many eigenvalues are above `cutoff` times the largest.
  static int rank(const Vec3& values, double cutoff);
  Vec3 boundary_minimiser(const Vec3& lo, const Vec3& hi) const;

  Vec3 centre_;
  Eigen::Matrix3d a_ = Eigen::Matrix3d::Zero();
  Vec3 b_ = Vec3::Zero();
  double c_ = 0;
};

/// A point, and its largest distance to the planes that it should lie in.
struct Minimiser {
  Vec3 point;
  double residual;
};

/// Tells whether two of the planes face away from each other and differ by less than 30 degrees
/// otherwise, as the sides of a knife do.
bool some_face_away(std::span<const Plane* const> planes);

/// Returns the point that `minimiser_in` finds with the usual cutoff. If the residual of this point
/// is more than half the tolerance, returns the point found with the fine cutoff instead, provided
/// that its residual is smaller. `residual(x)` must return the largest distance of x to the planes.
///
/// The planes of a knife's sides determine its edge by the fine cutoff only. If they pass together
/// through a point of the box, this is the point. `is_knife()` must tell whether there are such
/// planes.
template <typename Residual, typename IsKnife>
Minimiser minimiser_within(const PrimalQuadric& quadric, const Vec3& lo, const Vec3& hi,
                           double tolerance, const Residual& residual, const IsKnife& is_knife) {
  const Vec3 spread = quadric.spread();
  if (PrimalQuadric::is_blurred(spread) && is_knife()) {
    constexpr double kTogether = 0.0625;  // tolerances
    const Vec3 edge = quadric.minimiser(spread, PrimalQuadric::kFineCutoff);
    const bool inside = (edge.array() >= lo.array()).all() && (edge.array() <= hi.array()).all();
    const double apart = inside ? residual(edge) : tolerance;
    if (apart <= kTogether * tolerance) return {edge, apart};
  }
  const Vec3 coarse = quadric.minimiser_in(spread, lo, hi, PrimalQuadric::kRankCutoff);
  const double off = residual(coarse);
  if (off <= 0.5 * tolerance) return {coarse, off};
  const Vec3 fine = quadric.minimiser_in(spread, lo, hi, PrimalQuadric::kFineCutoff);
  const double fine_off = residual(fine);
  return fine_off < off ? Minimiser{fine, fine_off} : Minimiser{coarse, off};
}

/// Looks for a point of the box within the tolerance of all planes. Where many planes are nearly
/// the same, they draw the plain minimiser away from the other planes; here the weights of distant
/// planes grow step by step until none is too far (C. L. Lawson, Contributions to the theory of
/// linear least maximum approximation, 1961). Returns nothing if there is no such point, or none
/// was found in ten steps.
std::optional<Vec3> point_within(std::span<const Plane> planes, const Vec3& centre, const Vec3& lo,
                                 const Vec3& hi, double tolerance);

}  // namespace kdm
