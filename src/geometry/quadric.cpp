// SPDX-License-Identifier: MIT
// Minimisers of primal quadrics.
#include "geometry/quadric.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace kdm {

SymmetricEigen symmetric_eigen(const Eigen::Matrix3d& matrix) {
  Eigen::Matrix3d a = matrix;
  Eigen::Matrix3d v = Eigen::Matrix3d::Identity();
  const double scale = a.squaredNorm();
  constexpr int kSweeps = 12;  // four or five are the rule
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    const double off = a(0, 1) * a(0, 1) + a(0, 2) * a(0, 2) + a(1, 2) * a(1, 2);
    if (off <= 1e-28 * scale) break;
    for (int p = 0; p < 2; ++p) {
      for (int q = p + 1; q < 3; ++q) {
        if (a(p, q) == 0) continue;
        // Rotation by the smaller angle that makes a(p, q) zero.
        const double theta = (a(q, q) - a(p, p)) / (2 * a(p, q));
        const double t = (theta >= 0 ? 1 : -1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
        const double c = 1 / std::sqrt(t * t + 1);
        const double s = t * c;
        const int r = 3 - p - q;
        const double apq = a(p, q);
        const double apr = a(p, r);
        const double aqr = a(q, r);
        a(p, p) -= t * apq;
        a(q, q) += t * apq;
        a(p, q) = a(q, p) = 0;
        a(p, r) = a(r, p) = c * apr - s * aqr;
        a(q, r) = a(r, q) = s * apr + c * aqr;
        for (int k = 0; k < 3; ++k) {
          const double vp = v(k, p);
          const double vq = v(k, q);
          v(k, p) = c * vp - s * vq;
          v(k, q) = s * vp + c * vq;
        }
      }
    }
  }
  std::array<int, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](int i, int j) { return a(i, i) != a(j, j) ? a(i, i) > a(j, j) : i < j; });
  SymmetricEigen result;
  for (int k = 0; k < 3; ++k) {
    result.values[k] = a(order[k], order[k]);
    result.vectors.col(k) = v.col(order[k]);
  }
  return result;
}

namespace {

// Where the planes are nearly one, which is what most vertices see, only the largest eigenvalue
// counts, and powers of the matrix show its vector: squared three times, the others' share is
// below rounding.
bool dominant_direction(const Eigen::Matrix3d& a, double cutoff, Vec3& direction) {
  const double trace = a.trace();
  const double minors = a(0, 0) * a(1, 1) - a(0, 1) * a(0, 1) + a(0, 0) * a(2, 2) -
                        a(0, 2) * a(0, 2) + a(1, 1) * a(2, 2) - a(1, 2) * a(1, 2);
  // The minors add up to the largest eigenvalue times the sum of the others, or a little more.
  if (!(minors < 0.5 * cutoff * trace * trace)) return false;
  Eigen::Matrix3d power = a / trace;
  for (int i = 0; i < 3; ++i) power = (power * power).eval();
  int longest = 0;
  power.diagonal().maxCoeff(&longest);
  direction = power.col(longest) / power.col(longest).norm();
  return true;
}

}  // namespace

Vec3 PrimalQuadric::minimiser(double cutoff) const {
  Vec3 direction;
  if (dominant_direction(a_, cutoff, direction)) {
    return centre_ + direction * (direction.dot(b_) / direction.dot(a_ * direction));
  }
  const SymmetricEigen eigen = symmetric_eigen(a_);
  Vec3 y = Vec3::Zero();
  for (int k = 0; k < 3; ++k) {
    if (!(eigen.values[k] > cutoff * eigen.values[0])) break;
    const Vec3 axis = eigen.vectors.col(k);
    y += axis * (axis.dot(b_) / eigen.values[k]);
  }
  return centre_ + y;
}

Vec3 PrimalQuadric::certainty() const {
  const SymmetricEigen eigen = symmetric_eigen(a_);
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < 3; ++k) {
    if (!(eigen.values[k] > kRankCutoff * eigen.values[0])) break;
    sum += eigen.vectors.col(k).cwiseAbs2();
  }
  return sum;
}

Vec3 PrimalQuadric::minimiser_in(const Vec3& lo, const Vec3& hi, double cutoff) const {
  const Vec3 x = minimiser(cutoff);
  const bool inside = (x.array() >= lo.array()).all() && (x.array() <= hi.array()).all();
  return inside ? x : boundary_minimiser(lo, hi);
}

Vec3 PrimalQuadric::boundary_minimiser(const Vec3& lo, const Vec3& hi) const {
  // A little weight on the distance to the centre makes every system regular and breaks ties
  // where the quadric is flat.
  constexpr double kDamping = 1e-4;
  Eigen::Matrix3d a = a_;
  a.diagonal().array() += kDamping * std::max(a_.trace(), 1e-300);
  const Vec3 low = lo - centre_;
  const Vec3 high = hi - centre_;
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
      Vec3 y;
      y[k] = high_side ? high[k] : low[k];
      // The face: a 2x2 system.
      const double ru = b_[u] - a(u, k) * y[k];
      const double rv = b_[v] - a(v, k) * y[k];
      const double determinant = a(u, u) * a(v, v) - a(u, v) * a(u, v);
      y[u] = (ru * a(v, v) - rv * a(u, v)) / determinant;
      y[v] = (rv * a(u, u) - ru * a(u, v)) / determinant;
      if (y[u] >= low[u] && y[u] <= high[u] && y[v] >= low[v] && y[v] <= high[v]) {
        consider(y);
        continue;
      }
      // Its four edges; clamping covers the corners.
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
    // Nowhere is the largest distance less than the least mean of squares tells.
    if (squares > tolerance * tolerance || !(sum > 0)) return std::nullopt;
    for (double& weight : weights) weight /= sum;
  }
  return std::nullopt;
}

}  // namespace kdm
