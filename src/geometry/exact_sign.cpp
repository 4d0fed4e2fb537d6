// SPDX-License-Identifier: MIT
// Exact signs: filter, then expansions.
#include "geometry/exact_sign.h"

#include <cmath>
#include <vector>

namespace kdm {
namespace {

constexpr double kEpsilon = 0x1p-53;
constexpr double kVolumeBound = (7 + 56 * kEpsilon) * kEpsilon;
constexpr double kAreaBound = (3 + 16 * kEpsilon) * kEpsilon;

int sign_of(double value) { return value > 0 ? 1 : (value < 0 ? -1 : 0); }

// A sum of doubles that do not overlap, of growing magnitude: its sign is that of the last one.
using Expansion = std::vector<double>;

// a + b = sum + error, exactly.
void two_sum(double a, double b, double& sum, double& error) {
  sum = a + b;
  const double b_part = sum - a;
  error = (a - (sum - b_part)) + (b - b_part);
}

// a * b = product + error, exactly; halves of 26 bits multiply without rounding.
void two_product(double a, double b, double& product, double& error) {
  constexpr double kSplitter = 0x1p27 + 1;
  const double a_big = kSplitter * a;
  const double a_high = a_big - (a_big - a);
  const double a_low = a - a_high;
  const double b_big = kSplitter * b;
  const double b_high = b_big - (b_big - b);
  const double b_low = b - b_high;
  product = a * b;
  error = a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low);
}

void add(Expansion& to, double value) {
  Expansion result;
  double carry = value;
  for (const double term : to) {
    double error = 0;
    two_sum(carry, term, carry, error);
    if (error != 0) result.push_back(error);
  }
  if (carry != 0) result.push_back(carry);
  to = std::move(result);
}

Expansion difference(double a, double b) {
  double sum = 0;
  double error = 0;
  two_sum(a, -b, sum, error);
  Expansion result;
  if (error != 0) result.push_back(error);
  if (sum != 0) result.push_back(sum);
  return result;
}

Expansion product(const Expansion& a, const Expansion& b) {
  Expansion result;
  for (const double x : a) {
    for (const double y : b) {
      double high = 0;
      double low = 0;
      two_product(x, y, high, low);
      add(result, low);
      add(result, high);
    }
  }
  return result;
}

void add(Expansion& to, const Expansion& terms, double sign = 1) {
  for (const double term : terms) add(to, sign * term);
}

int sign_of(const Expansion& value) { return value.empty() ? 0 : sign_of(value.back()); }

int exact_volume_sign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  // Rows a - d, b - d, c - d; the determinant's sign is turned as in volume_sign.
  Expansion rows[3][3];
  for (int k = 0; k < 3; ++k) {
    rows[0][k] = difference(a[k], d[k]);
    rows[1][k] = difference(b[k], d[k]);
    rows[2][k] = difference(c[k], d[k]);
  }
  Expansion determinant;
  for (int k = 0; k < 3; ++k) {
    Expansion minor = product(rows[1][(k + 1) % 3], rows[2][(k + 2) % 3]);
    add(minor, product(rows[1][(k + 2) % 3], rows[2][(k + 1) % 3]), -1);
    add(determinant, product(rows[0][k], minor));
  }
  return -sign_of(determinant);
}

}  // namespace

int volume_sign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ad = a - d;
  const Vec3 bd = b - d;
  const Vec3 cd = c - d;
  double determinant = 0;
  double permanent = 0;
  for (int k = 0; k < 3; ++k) {
    const double first = bd[(k + 1) % 3] * cd[(k + 2) % 3];
    const double second = bd[(k + 2) % 3] * cd[(k + 1) % 3];
    determinant += ad[k] * (first - second);
    permanent += std::abs(ad[k]) * (std::abs(first) + std::abs(second));
  }
  // One rounding more than in the paper's bound for the sum in this order; twice it is plenty.
  if (std::abs(determinant) > 2 * kVolumeBound * permanent) return -sign_of(determinant);
  return exact_volume_sign(a, b, c, d);
}

int area_sign(const Vec3& a, const Vec3& b, const Vec3& c, int axis) {
  const int u = axis == 2 ? 0 : axis + 1;
  const int v = axis == 0 ? 2 : axis - 1;
  const double left = (a[u] - c[u]) * (b[v] - c[v]);
  const double right = (a[v] - c[v]) * (b[u] - c[u]);
  const double area = left - right;
  if (std::abs(area) > 2 * kAreaBound * (std::abs(left) + std::abs(right))) return sign_of(area);
  Expansion exact = product(difference(a[u], c[u]), difference(b[v], c[v]));
  add(exact, product(difference(a[v], c[v]), difference(b[u], c[u])), -1);
  return sign_of(exact);
}

}  // namespace kdm
