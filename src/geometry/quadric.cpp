// SPDX-License-Identifier: MIT
// Finds minimisers of primal quadrics.
#include "geometry/quadric.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/symmetric.h"

namespace kdm {

int PrimalQuadric::rank(const Vec3& values, double cutoff) {
  int rank = 0;
  while (rank < 3 && values[rank] > cutoff * values[0]) ++rank;
  return rank;
}

// Multiplies b by the pseudo-inverse of A. By the theorem of Cayley and Hamilton, A has the inverse
// (l0 + l1 - A) / (l0 l1) in the plane of its first two eigenvectors, whose eigenvalues are l0 and
// l1.
Vec3 PrimalQuadric::minimiser(const Vec3& values, double cutoff) const {
  switch (rank(values, cutoff)) {
    case 0:
      return centre_;
    case 1: {
      const Vec3 axis = eigenvector(a_, values[0]);
      return centre_ + axis * (axis.dot(b_) / values[0]);
    }
    case 2: {
      const Vec3 normal = eigenvector(a_, values[2]);
      const Vec3 b = b_ - normal * normal.dot(b_);
      return centre_ + ((values[0] + values[1]) * b - a_ * b) / (values[0] * values[1]);
    }
    default:
      return centre_ + solve(a_, b_);
  }
}

Vec3 PrimalQuadric::certainty() const {
  const Vec3 values = eigenvalues(a_);
  switch (rank(values, kRankCutoff)) {
    case 0:
      return Vec3::Zero();
    case 1:
      return eigenvector(a_, values[0]).cwiseAbs2();
    case 2:
      return Vec3::Ones() - eigenvector(a_, values[2]).cwiseAbs2();
    default:
      return Vec3::Ones();
  }
}

Vec3 PrimalQuadric::minimiser_in(const Vec3& values, const Vec3& lo, const Vec3& hi,
                                 double cutoff) const {
  const Vec3 x = minimiser(values, cutoff);
  const bool inside = (x.array() >= lo.array()).all() && (x.array() <= hi.array()).all();
  return inside ? x : boundary_minimiser(lo, hi);
}

Vec3 PrimalQuadric::boundary_minimiser(const Vec3& lo, const Vec3& hi) const {
  // The distance to the centre counts a little: that makes every system of equations regular and
  // breaks ties where the quadric is flat.
  constexpr double kDamping = 1e-4;
  Eigen::Matrix3d a = a_;
  a.diagonal().array() += kDamping * std::max(a_.trace(), 1e-300);
  const Vec3 low = lo - centre_;
  const Vec3 high = hi - centre_;
  // If the free minimiser is outside the box, the least value in the box is on one of the faces
  // that it is beyond.
  const Vec3 free = solve(a, b_);
  const bool inside = (free.array() >= low.array()).all() && (free.array() <= high.array()).all();
  Vec3 best = Vec3::Zero();
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](const Vec3& y) {
    const double value = y.dot(a * y) - 2 * b_.dot(y);
    if (value < least) {
      least = value;
      best = y;
    }
  };
  for (int k = 0; k < 3; ++k) {
    const int u = k == 2 ? 0 : k + 1;
    const int v = k == 0 ? 2 : k - 1;
    for (const bool high_side : {false, true}) {
      if (!inside && (high_side ? free[k] <= high[k] : free[k] >= low[k])) continue;
      Vec3 y;
      y[k] = high_side ? high[k] : low[k];
      // On a face, the minimiser solves a 2x2 system.
      const double ru = b_[u] - a(u, k) * y[k];
      const double rv = b_[v] - a(v, k) * y[k];
      const double determinant = a(u, u) * a(v, v) - a(u, v) * a(u, v);
      y[u] = (ru * a(v, v) - rv * a(u, v)) / determinant;
      y[v] = (rv * a(u, u) - ru * a(u, v)) / determinant;
      if (y[u] >= low[u] && y[u] <= high[u] && y[v] >= low[v] && y[v] <= high[v]) {
        consider(y);
        continue;
      }
      // Else it is on one of the four edges, or on a corner: clamping covers these.
      for (const bool high_edge : {false, true}) {
        y[u] = high_edge ? high[u] : low[u];
        y[v] = (b_[v] - a(v, k) * y[k] - a(v, u) * y[u]) / a(v, v);
        y[v] = std::min(std::max(y[v], low[v]), high[v]);
        consider(y);
      }
      for (const bool high_edge : {false, true}) {
        y[v] = high_edge ? high[v] : low[v];
        y[u] = (b_[u] - a(u, k) * y[k] - a(u, v) * y[v]) / a(u, u);
        y[u] = std::min(std::max(y[u], low[u]), high[u]);
        consider(y);
      }
    }
  }
  return centre_ + best;
}

bool some_face_away(std::span<const Plane* const> planes) {
  constexpr double kCosine = -0.866;
  for (std::size_t i = 1; i < planes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (planes[i]->normal.dot(planes[j]->normal) < kCosine) return true;
    }
  }
  return false;
}

std::optional<Vec3> point_within(std::span<const Plane> planes, const Vec3& centre, const Vec3& lo,
                                 const Vec3& hi, double tolerance) {
  constexpr int kRounds = 10;
  std::vector<double> weights(planes.size(), 1.0 / static_cast<double>(planes.size()));
  for (int round = 0; round < kRounds; ++round) {
    PrimalQuadric quadric(centre);
    for (std::size_t i = 0; i < planes.size(); ++i) {
      const double weight = std::sqrt(weights[i]);
      quadric.add({weight * planes[i].normal, weight * planes[i].offset});
    }
    const Vec3 x = quadric.minimiser_in(lo, hi, PrimalQuadric::kFineCutoff);
    double largest = 0;
    double sum = 0;
    double squares = 0;
    for (std::size_t i = 0; i < planes.size(); ++i) {
      const double distance = planes[i].distance(x);
      largest = std::max(largest, distance);
      squares += weights[i] * distance * distance;
      weights[i] *= distance;
      sum += weights[i];
    }
    if (largest <= tolerance) return x;
    // At no point is the largest distance less than the root of the least weighted mean of squares.
    if (squares > tolerance * tolerance || !(sum > 0)) return std::nullopt;
    for (double& weight : weights) weight /= sum;
  }
  return std::nullopt;
}

}  // namespace kdm
