// SPDX-License-Identifier: MIT
// Decides exactly whether mesh vertices lie below grid planes, on which side of a mesh edge a grid
// line passes, and where grid lines meet triangles. One perturbation resolves all ties.
//
// The mesh is read as translated by (-e, -e^2, -e^3), e infinitesimal, which is the same as every
// grid point shifted by (+e, +e^2, +e^3). Then no grid plane contains a mesh vertex, no grid line
// meets a mesh edge and no grid vertex lies on a triangle, and the answers along all axes fit
// together. Paper 5.1.1 clips in floating point instead; that disagrees with itself where cells of
// different splits see one grid vertex. All values fit 64 bits (see lattice.h).
#pragma once

#include "geometry/lattice.h"

namespace kdm {

/// Tells whether a mesh vertex with this coordinate is below the lattice plane `plane` of that
/// axis.
constexpr bool below_plane(std::int32_t coordinate, std::int32_t plane) {
  return coordinate <= plane;
}

/// Returns the sign of the area of the triangle (a, b, p), seen along `axis`: 1 if p is to the left
/// of the mesh edge from a to b in the plane of the next and the previous axis. p is a grid point,
/// given by its coordinates pu and pv on these two axes. Returns 0 only if a and b are seen as one
/// point.
inline int side_of_edge(const LatticePoint& a, const LatticePoint& b, int axis, std::int32_t pu,
                        std::int32_t pv) {
  const int u = next_axis(axis);
  const int v = previous_axis(axis);
  const std::int64_t du = b[u] - a[u];
  const std::int64_t dv = b[v] - a[v];
  const std::int64_t area = du * (pv - a[v]) - dv * (pu - a[u]);
  if (area != 0) return area > 0 ? 1 : -1;
  // d(area)/d(pu) = -dv and d(area)/d(pv) = du; the axis with the lower number is shifted most.
  const std::int64_t first = u < v ? -dv : du;
  const std::int64_t second = u < v ? du : -dv;
  if (first != 0) return first > 0 ? 1 : -1;
  return second > 0 ? 1 : (second < 0 ? -1 : 0);
}

/// Returns how the grid line along `axis` through (pu, pv) meets the triangle: 0 if it does not,
/// else the sign of the triangle's normal along `axis`.
inline int line_crosses(const LatticeTriangle& t, int axis, std::int32_t pu, std::int32_t pv) {
  const int first = side_of_edge(t[0], t[1], axis, pu, pv);
  if (first == 0 || side_of_edge(t[1], t[2], axis, pu, pv) != first) return 0;
  return side_of_edge(t[2], t[0], axis, pu, pv) == first ? first : 0;
}

/// Returns twice the triangle's area vector, which points along its normal, in squared lattice
/// units. Each component is at most 2^40.
inline std::array<std::int64_t, 3> area_vector(const LatticeTriangle& t) {
  std::array<std::int64_t, 3> e{}, f{};
  for (int i = 0; i < 3; ++i) {
    e[i] = t[1][i] - t[0][i];
    f[i] = t[2][i] - t[0][i];
  }
  return {e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]};
}

/// Tells whether two triangles lie in one plane and face the same way.
inline bool lie_on_each_other(const LatticeTriangle& s, const LatticeTriangle& t) {
  const std::array<std::int64_t, 3> normal = area_vector(s);
  for (const LatticePoint& p : t) {
    std::int64_t height = 0;
    for (int i = 0; i < 3; ++i) height += normal[i] * (p[i] - s[0][i]);
    if (height != 0) return false;
  }
  const std::array<std::int64_t, 3> other = area_vector(t);
  for (int i = 0; i < 3; ++i) {
    if (normal[i] != 0) return (normal[i] > 0) == (other[i] > 0);
  }
  return false;
}

/// Tells whether the triangle's normal points up the axis.
inline bool points_up(const LatticeTriangle& t, int axis) { return area_vector(t)[axis] > 0; }

/// A position on a grid line, in units of 2^-12 lattice steps. Its integer part is exact: the
/// position is below the lattice plane s iff floor_of(position) < s. Its fraction is rounded.
using LinePosition = std::uint32_t;
inline constexpr int kFractionBits = 12;
inline constexpr double kFractionUnit = 1.0 / (1 << kFractionBits);

/// Returns the lattice plane at or next below a position.
constexpr std::int32_t floor_of(LinePosition position) {
  return static_cast<std::int32_t>(position >> kFractionBits);
}
/// Returns a position in lattice units.
constexpr double real_position(LinePosition position) { return position * kFractionUnit; }

/// Returns where the grid line along `axis` through (pu, pv) meets the triangle. The line must meet
/// it (see `line_crosses`).
inline LinePosition crossing_position(const LatticeTriangle& t, int axis, std::int32_t pu,
                                      std::int32_t pv) {
  const int u = next_axis(axis);
  const int v = previous_axis(axis);
  const std::array<std::int64_t, 3> normal = area_vector(t);
  const bool up = normal[axis] > 0;
  // position = t[0][axis] + numerator / denominator
  const std::int64_t denominator = up ? normal[axis] : -normal[axis];
  const std::int64_t offset = normal[u] * (pu - t[0][u]) + normal[v] * (pv - t[0][v]);
  const std::int64_t numerator = up ? -offset : offset;
  // The rounded quotient is wrong by one at most; the remainder tells, and corrects it.
  auto quotient = static_cast<std::int64_t>(
      std::floor(static_cast<double>(numerator) / static_cast<double>(denominator)));
  std::int64_t remainder = numerator - quotient * denominator;
  if (remainder < 0) {
    --quotient;
    remainder += denominator;
  } else if (remainder >= denominator) {
    ++quotient;
    remainder -= denominator;
  }
  const std::int64_t whole = t[0][axis] + quotient;
  constexpr std::int64_t kLastFraction = (1 << kFractionBits) - 1;
  if (remainder == 0) {
    // The plane passes through the lattice point itself, which is shifted by (e, e^2, e^3): the
    // hit is below it iff the first component of the normal that is not zero has axis's sign.
    const std::int64_t first =
        normal[0] != 0 ? normal[0] : (normal[1] != 0 ? normal[1] : normal[2]);
    if ((first > 0) == up) {
      return static_cast<LinePosition>(((whole - 1) << kFractionBits) | kLastFraction);
    }
    return static_cast<LinePosition>(whole << kFractionBits);
  }
  auto fraction =
      static_cast<std::int64_t>(static_cast<double>(remainder) / static_cast<double>(denominator) *
                                static_cast<double>(1 << kFractionBits));
  if (fraction > kLastFraction) fraction = kLastFraction;
  return static_cast<LinePosition>((whole << kFractionBits) | fraction);
}

}  // namespace kdm
