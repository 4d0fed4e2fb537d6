// SPDX-License-Identifier: MIT
// An oracle for the predicates, slow and plain: every coordinate is a polynomial in the
// infinitesimal e with 128-bit coefficients, determinants are expanded term by term, and the sign
// of a number is that of its first coefficient that is not zero. It shares nothing with
// src/geometry/predicates.h.
#pragma once

#include <array>
#include <cstdint>

namespace kdm::oracle {

/// The number c[0] + c[1] e + c[2] e^2 + ... Products of three coordinates have a degree of nine at
/// most. If coordinates are below 2^22, no coefficient exceeds 2^80.
struct Polynomial {
  static constexpr std::size_t kTerms = 10;
  std::array<__int128, kTerms> c{};

  Polynomial() = default;
  Polynomial(std::int64_t constant) { c[0] = constant; }  // NOLINT: numbers are polynomials

  static Polynomial e_to(std::size_t power) {
    Polynomial p;
    p.c[power] = 1;
    return p;
  }

  friend Polynomial operator+(const Polynomial& a, const Polynomial& b) {
    Polynomial sum;
    for (std::size_t i = 0; i < kTerms; ++i) sum.c[i] = a.c[i] + b.c[i];
    return sum;
  }
  friend Polynomial operator-(const Polynomial& a, const Polynomial& b) {
    Polynomial difference;
    for (std::size_t i = 0; i < kTerms; ++i) difference.c[i] = a.c[i] - b.c[i];
    return difference;
  }
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    Polynomial product;
    for (std::size_t i = 0; i < kTerms; ++i) {
      for (std::size_t j = 0; i + j < kTerms; ++j) product.c[i + j] += a.c[i] * b.c[j];
    }
    return product;
  }

  /// Returns the sign of the number for every e that is positive and small enough.
  int sign() const {
    for (const __int128 coefficient : c) {
      if (coefficient != 0) return coefficient > 0 ? 1 : -1;
    }
    return 0;
  }
};

using Point = std::array<Polynomial, 3>;

inline Point mesh_vertex(const std::array<std::int32_t, 3>& p) { return {p[0], p[1], p[2]}; }

/// Returns a grid point, which is shifted by (e, e^2, e^3).
inline Point grid_point(const std::array<std::int64_t, 3>& p) {
  return {Polynomial(p[0]) + Polynomial::e_to(1), Polynomial(p[1]) + Polynomial::e_to(2),
          Polynomial(p[2]) + Polynomial::e_to(3)};
}

/// Returns the sign of det(b - a, c - a, d - a): positive if d lies on the side to which the normal
/// of the counter-clockwise triangle (a, b, c) points.
inline int orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
  std::array<Point, 3> row;
  for (std::size_t i = 0; i < 3; ++i) {
    row[0][i] = b[i] - a[i];
    row[1][i] = c[i] - a[i];
    row[2][i] = d[i] - a[i];
  }
  const auto minor = [&](std::size_t i, std::size_t j) {
    return row[1][i] * row[2][j] - row[1][j] * row[2][i];
  };
  return (row[0][0] * minor(1, 2) - row[0][1] * minor(0, 2) + row[0][2] * minor(0, 1)).sign();
}

/// The grid line through (u, v) along `axis`, as two points far below and far above the lattice.
struct GridLine {
  std::array<std::int64_t, 3> low{}, high{};
  std::size_t axis = 0;

  GridLine(int line_axis, std::int64_t u, std::int64_t v)
      : axis(static_cast<std::size_t>(line_axis)) {
    low[(axis + 1) % 3] = high[(axis + 1) % 3] = u;
    low[(axis + 2) % 3] = high[(axis + 2) % 3] = v;
    low[axis] = -(std::int64_t{1} << 21);
    high[axis] = std::int64_t{1} << 21;
  }
  Point at(std::int64_t position) const {
    std::array<std::int64_t, 3> p = low;
    p[axis] = position;
    return grid_point(p);
  }
};

/// Returns 0 if the line misses the triangle, else the sign of the triangle's normal along the
/// line.
inline int line_crosses(const std::array<std::array<std::int32_t, 3>, 3>& triangle,
                        const GridLine& line) {
  const Point low = grid_point(line.low);
  const Point high = grid_point(line.high);
  const std::array<Point, 3> t = {mesh_vertex(triangle[0]), mesh_vertex(triangle[1]),
                                  mesh_vertex(triangle[2])};
  const int first = orientation(low, high, t[0], t[1]);
  if (first == 0 || orientation(low, high, t[1], t[2]) != first ||
      orientation(low, high, t[2], t[0]) != first) {
    return 0;
  }
  // The line's two ends must lie on different sides of the plane; which is which is the sign.
  const int above = orientation(t[0], t[1], t[2], high);
  return above != 0 && above == -orientation(t[0], t[1], t[2], low) ? above : 0;
}

/// Tells whether the line crosses the triangle below the line's grid point at `plane`. `sign` must
/// be the sign of the triangle's normal along the line.
inline bool crossing_below(const std::array<std::array<std::int32_t, 3>, 3>& triangle,
                           const GridLine& line, int sign, std::int64_t plane) {
  return orientation(mesh_vertex(triangle[0]), mesh_vertex(triangle[1]), mesh_vertex(triangle[2]),
                     line.at(plane)) == sign;
}

}  // namespace kdm::oracle
