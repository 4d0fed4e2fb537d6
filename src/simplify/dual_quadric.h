// SPDX-License-Identifier: MIT
// The dual quadric: the sum of the squared distances of a set of points to a plane, and the plane
// for which it is least (paper 4.2.2; M. Garland, A. Willmott, P. Heckbert, Hierarchical face
// clustering on polygonal surfaces, 2001).
#pragma once

#include <algorithm>

#include "geometry/symmetric.h"

namespace kdm {

/// The points, kept as their number, their mean and their scatter about it: sums of squared
/// coordinates (paper, equation 11) cancel where the points are near to each other and far from the
/// origin.
class DualQuadric {
 public:
  DualQuadric() = default;  // no points
  /// A disk of the surface: its scatter is that of points spread over it, so that the plane of the
  /// best fit is known from the first one on.
  DualQuadric(const Vec3& centre, const Vec3& normal, double radius)
      : count_(1),
        mean_(centre),
        scatter_(0.25 * radius * radius *
                 (Eigen::Matrix3d::Identity() - normal * normal.transpose())) {}

  /// Adds the points of another one.
  void add(const DualQuadric& other) {
    const double sum = count_ + other.count_;
    if (sum == 0) return;
    const Vec3 apart = other.mean_ - mean_;
    scatter_ += other.scatter_ + (count_ * other.count_ / sum) * apart * apart.transpose();
    mean_ += (other.count_ / sum) * apart;
    count_ = sum;
  }

  /// Returns the mean squared distance to the plane for which it is least: the on-metric of the
  /// paper for one plane (equation 5).
  double least_error() const {
    return count_ == 0 ? 0 : std::max(0.0, eigenvalues(scatter_)[2]) / count_;
  }

 private:
  double count_ = 0;
  Vec3 mean_ = Vec3::Zero();
  Eigen::Matrix3d scatter_ = Eigen::Matrix3d::Zero();
};

}  // namespace kdm
