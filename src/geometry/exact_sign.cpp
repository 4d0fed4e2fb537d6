// SPDX-License-Identifier: MIT
// Computes signs with an error bound first, then with expansions.
#include "geometry/exact_sign.h"

#include <array>
#include <cmath>

namespace kdm {
namespace {

constexpr double kEpsilon = 0x1p-53;
constexpr double kVolumeBound = (7 + 56 * kEpsilon) * kEpsilon;
constexpr double kAreaBound = (3 + 16 * kEpsilon) * kEpsilon;

int sign_of(double value) { return value > 0 ? 1 : (value < 0 ? -1 : 0); }

// Splits a + b into its rounded value and the rest: a + b = sum + error exactly.
void two_sum(double a, double b, double& sum, double& error) {
  sum = a + b;
  const double b_part = sum - a;
  error = (a - (sum - b_part)) + (b - b_part);
}

// Splits a * b likewise: a * b = product + error exactly. Halves of 26 bits multiply without
// rounding.
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

// An exact number: the sum of doubles that do not overlap, of growing magnitude. Its sign is that
// of the last one.
template <int kCapacity>
struct Expansion {
  std::array<double, kCapacity> terms;
  int size = 0;

  void add(double value) {
    double carry = value;
    int kept = 0;
    for (int i = 0; i < size; ++i) {
      double error = 0;
      two_sum(carry, terms[i], carry, error);
      if (error != 0) terms[kept++] = error;
    }
    if (carry != 0) terms[kept++] = carry;
    size = kept;
  }

  // The exact product of two terms takes two terms.
  template <int kFirst, int kSecond>
  void add_product(const Expansion<kFirst>& a, const Expansion<kSecond>& b, double sign = 1) {
    static_assert(2 * kFirst * kSecond <= kCapacity);
    for (int i = 0; i < a.size; ++i) {
      for (int j = 0; j < b.size; ++j) {
        double high = 0;
        double low = 0;
        two_product(a.terms[i], b.terms[j], high, low);
        add(sign * low);
        add(sign * high);
      }
    }
  }

  int sign() const { return size == 0 ? 0 : sign_of(terms[size - 1]); }
};

using Difference = Expansion<2>;

Difference difference(double a, double b) {
  Difference result;
  double sum = 0;
  double error = 0;
  two_sum(a, -b, sum, error);
  result.add(error);
  result.add(sum);
  return result;
}

int exact_volume_sign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  // Rows a - d, b - d, c - d; the determinant's sign is turned as in volume_sign.
  std::array<std::array<Difference, 3>, 3> rows;
  for (int k = 0; k < 3; ++k) {
    rows[0][k] = difference(a[k], d[k]);
    rows[1][k] = difference(b[k], d[k]);
    rows[2][k] = difference(c[k], d[k]);
  }
  Expansion<192> determinant;
  for (int k = 0; k < 3; ++k) {
    Expansion<16> minor;
    minor.add_product(rows[1][(k + 1) % 3], rows[2][(k + 2) % 3]);
    minor.add_product(rows[1][(k + 2) % 3], rows[2][(k + 1) % 3], -1);
    determinant.add_product(rows[0][k], minor);
  }
  return -determinant.sign();
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
  // Summed up in this order there is one rounding more than the bound in Shewchuk's paper allows
  // for: twice the bound is plenty.
  if (std::abs(determinant) > 2 * kVolumeBound * permanent) return -sign_of(determinant);
  // All products are 0, as where all points lie in one axis-parallel plane.
  if (permanent == 0) return 0;
  return exact_volume_sign(a, b, c, d);
}

int area_sign(const Vec3& a, const Vec3& b, const Vec3& c, int axis) {
  const int u = axis == 2 ? 0 : axis + 1;
  const int v = axis == 0 ? 2 : axis - 1;
  const double left = (a[u] - c[u]) * (b[v] - c[v]);
  const double right = (a[v] - c[v]) * (b[u] - c[u]);
  const double area = left - right;
  if (std::abs(area) > 2 * kAreaBound * (std::abs(left) + std::abs(right))) return sign_of(area);
  if (left == 0 && right == 0) return 0;
  Expansion<16> exact;
  exact.add_product(difference(a[u], c[u]), difference(b[v], c[v]));
  exact.add_product(difference(a[v], c[v]), difference(b[u], c[u]), -1);
  return exact.sign();
}

bool has_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  for (int axis = 0; axis < 3; ++axis) {
    if (area_sign(a, b, c, axis) != 0) return true;
  }
  return false;
}

}  // namespace kdm
