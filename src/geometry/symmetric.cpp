// SPDX-License-Identifier: MIT
// Finds roots of the characteristic polynomial, and eigenvectors in adjugates.
#include "geometry/symmetric.h"

#include <algorithm>
#include <cmath>

namespace kdm {
namespace {

double determinant(const Eigen::Matrix3d& a, const Eigen::Matrix3d& adjugate) {
  return a(0, 0) * adjugate(0, 0) + a(0, 1) * adjugate(0, 1) + a(0, 2) * adjugate(0, 2);
}

// Returns the root e in [0, 0.5] of 4 e^3 + 6 e^2 = d, where d is in [0, 2]. These Newton steps
// subtract nothing, so e is exact even where it is nearly a double root.
double excess(double d) {
  constexpr int kSteps = 4;
  double e = std::sqrt(d / 8);
  for (int step = 0; step < kSteps && e > 0; ++step) {
    e = ((8 * e + 6) * e * e + d) / (12 * e * (e + 1));
  }
  return e;
}

}  // namespace

Eigen::Matrix3d adjugate(const Eigen::Matrix3d& a) {
  Eigen::Matrix3d c;
  c(0, 0) = a(1, 1) * a(2, 2) - a(1, 2) * a(1, 2);
  c(1, 1) = a(0, 0) * a(2, 2) - a(0, 2) * a(0, 2);
  c(2, 2) = a(0, 0) * a(1, 1) - a(0, 1) * a(0, 1);
  c(0, 1) = c(1, 0) = a(0, 2) * a(1, 2) - a(0, 1) * a(2, 2);
  c(0, 2) = c(2, 0) = a(0, 1) * a(1, 2) - a(0, 2) * a(1, 1);
  c(1, 2) = c(2, 1) = a(0, 1) * a(0, 2) - a(0, 0) * a(1, 2);
  return c;
}

Vec3 solve(const Eigen::Matrix3d& a, const Vec3& b) {
  const Eigen::Matrix3d c = adjugate(a);
  return c * b / determinant(a, c);
}

// Writes A = q + pB, where q is the mean of the eigenvalues. The largest eigenvalue of B is then
// 2 cos(acos(det B / 2) / 3), which is 1 + 2e for the root e of `excess`.
Vec3 eigenvalues(const Eigen::Matrix3d& symmetric) {
  Eigen::Matrix3d b = symmetric;
  const double mean = (b(0, 0) + b(1, 1) + b(2, 2)) / 3;
  for (int i = 0; i < 3; ++i) b(i, i) -= mean;
  const double beside = b(0, 1) * b(0, 1) + b(0, 2) * b(0, 2) + b(1, 2) * b(1, 2);
  const double on = b(0, 0) * b(0, 0) + b(1, 1) * b(1, 1) + b(2, 2) * b(2, 2);
  const double p = std::sqrt((on + 2 * beside) / 6);
  if (!(p > 0)) return Vec3::Constant(mean);
  b /= p;
  const double largest = 1 + 2 * excess(std::clamp(1 + determinant(b, adjugate(b)) / 2, 0.0, 2.0));
  const double half = 0.5 * std::sqrt(3 * std::max(2 - largest, 0.0) * (2 + largest));
  return {mean + p * largest, mean + p * (half - 0.5 * largest), mean - p * (half + 0.5 * largest)};
}

// All columns of the adjugate of A - lambda are multiples of the eigenvector; the longest is taken.
Vec3 eigenvector(const Eigen::Matrix3d& symmetric, double eigenvalue) {
  Eigen::Matrix3d a = symmetric;
  for (int i = 0; i < 3; ++i) a(i, i) -= eigenvalue;
  const Eigen::Matrix3d c = adjugate(a);
  int longest = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(c(i, i)) > std::abs(c(longest, longest))) longest = i;
  }
  const Vec3 column = c.col(longest);
  return column / column.norm();
}

}  // namespace kdm
