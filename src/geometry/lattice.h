// SPDX-License-Identifier: MIT
// The integer lattice on which every decision is made, and the map between it and model
// coordinates.
//
// 20 bits an axis are chosen so that every predicate fits 64-bit integers: the largest value is
// six times the volume of a tetrahedron in the root cube, at most 2 * (2^20)^3 = 2^61.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "kdmanifold/types.h"

namespace kdm {

/// How many bits a lattice coordinate has.
inline constexpr int kLatticeBits = 20;
/// The root cell is the cube [0, kLatticeSize]^3.
inline constexpr std::int32_t kLatticeSize = std::int32_t{1} << kLatticeBits;
/// The least distance of the input from the root cell's sides, in lattice units. It keeps the root
/// cell's edges outside the solid. It is odd, so that no plane that halves cells again and again
/// passes through the model's extreme points: a tip in a plane would reach through it infinitely
/// little, which no split resolves.
inline constexpr std::int32_t kLatticeMargin = kLatticeSize / 256 + 1;

/// A point of the lattice, in lattice units.
using LatticePoint = std::array<std::int32_t, 3>;

/// Returns the point's coordinates, in lattice units, as floating-point numbers.
inline Vec3 to_vec3(const LatticePoint& p) { return Vec3(p[0], p[1], p[2]); }

/// An axis-aligned box with lattice corners, both ends included.
struct LatticeBox {
  LatticePoint lo{0, 0, 0};
  LatticePoint hi{kLatticeSize, kLatticeSize, kLatticeSize};

  bool operator==(const LatticeBox&) const = default;
};

/// Returns the length of the box along an axis, in lattice units.
inline std::int32_t extent(const LatticeBox& box, int axis) { return box.hi[axis] - box.lo[axis]; }

/// Returns the axis along which the box is longest; if there are several, the first.
inline int longest_axis(const LatticeBox& box) {
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    if (extent(box, i) > extent(box, axis)) axis = i;
  }
  return axis;
}

/// Returns the point of the box's lattice points that is nearest to a point in lattice units.
inline LatticePoint nearest_point_in(const LatticeBox& box, const Vec3& point) {
  LatticePoint p;
  for (int i = 0; i < 3; ++i) {
    p[i] = static_cast<std::int32_t>(
        std::clamp(std::floor(point[i] + 0.5), double(box.lo[i]), double(box.hi[i])));
  }
  return p;
}

/// The corners of an input triangle, rounded to the lattice.
using LatticeTriangle = std::array<LatticePoint, 3>;

/// Return the two axes that follow `axis` in cyclic order. If u is the next axis and v the previous
/// one, the axes (u, v, axis) are right-handed.
constexpr int next_axis(int axis) { return axis == 2 ? 0 : axis + 1; }
constexpr int previous_axis(int axis) { return axis == 0 ? 2 : axis - 1; }

/// Returns a corner of the rectangle in which the box meets the plane `value` of `axis`: the one at
/// the high or the low end on the next and on the previous axis.
inline LatticePoint corner_on_plane(const LatticeBox& box, int axis, std::int32_t value,
                                    bool high_next, bool high_previous) {
  const int u = next_axis(axis);
  const int v = previous_axis(axis);
  LatticePoint p;
  p[axis] = value;
  p[u] = (high_next ? box.hi : box.lo)[u];
  p[v] = (high_previous ? box.hi : box.lo)[v];
  return p;
}

/// Maps model coordinates to lattice coordinates and back. The step is the same on every axis.
struct Lattice {
  Vec3 origin = Vec3::Zero();  ///< model coordinates of lattice point (0, 0, 0)
  double step = 1;             ///< model units per lattice unit

  bool operator==(const Lattice&) const = default;

  /// Returns lattice coordinates, not rounded.
  Vec3 to_lattice(const Vec3& model) const { return (model - origin) / step; }
  /// Returns model coordinates.
  Vec3 to_model(const Vec3& lattice) const { return origin + lattice * step; }
  /// Returns the lattice point nearest to a point in model coordinates.
  LatticePoint quantise(const Vec3& model) const {
    const Vec3 exact = to_lattice(model);
    return {static_cast<std::int32_t>(std::floor(exact[0] + 0.5)),
            static_cast<std::int32_t>(std::floor(exact[1] + 0.5)),
            static_cast<std::int32_t>(std::floor(exact[2] + 0.5))};
  }
};

/// Tells whether the box, in model units, keeps at least half of `kLatticeMargin` from the sides of
/// the root cell.
inline bool is_within_margins(const Lattice& lattice, const Box& bounds) {
  constexpr double kLow = 0.5 * kLatticeMargin;
  constexpr double kHigh = kLatticeSize - kLow;
  const bool outside = lattice.to_lattice(bounds.min).minCoeff() < kLow ||
                       lattice.to_lattice(bounds.max).maxCoeff() > kHigh;
  return !outside;
}

/// Returns the lattice that puts the box `bounds`, in model units, in the middle of the root cell
/// and leaves `kLatticeMargin` at the ends of its longest axis. A box without extent gets a step of
/// one model unit. If coordinates are so far from zero that rounding the origin would use up the
/// margin, the step is larger.
inline Lattice lattice_over(const Box& bounds) {
  const double extent = (bounds.max - bounds.min).maxCoeff();
  Lattice lattice;
  lattice.step = extent > 0 ? extent / (kLatticeSize - 2 * kLatticeMargin) : 1.0;
  // Quotients of subnormal numbers mean nothing: so small a box counts as a point.
  lattice.step = std::max(lattice.step, std::numeric_limits<double>::min());
  const Vec3 centre = bounds.min + 0.5 * (bounds.max - bounds.min);
  for (;;) {
    lattice.origin = centre - Vec3::Constant(lattice.step * (kLatticeSize / 2));
    if (is_within_margins(lattice, bounds)) return lattice;
    lattice.step *= 2;
  }
}

/// Returns how often the root cell is halved across each axis, to cells of which a box takes so
/// many along its longest side and leaves `kLatticeMargin` at both ends. Of half a million cells,
/// which is the most that is asked for, each is two lattice units wide.
inline int halvings_for(int cells) {
  for (int halvings = 1;; ++halvings) {
    const int beside = ((1 << halvings) - cells) / 2;
    if (beside > 0 && beside * (kLatticeSize >> halvings) >= kLatticeMargin) return halvings;
  }
}

/// Returns the lattice in which the box `bounds`, in model units, takes just so many cells along
/// its longest side once the root cell is halved `halvings_for(cells)` times across each axis. The
/// box begins where cells do; its sides lie a lattice unit off their planes, for the reason why
/// `kLatticeMargin` is odd. A box without extent gets a step of one model unit. If coordinates are
/// so far from zero that rounding the origin would use up the margin, the step is larger.
inline Lattice lattice_of_cells(const Box& bounds, int cells) {
  const double extent = (bounds.max - bounds.min).maxCoeff();
  const int halvings = halvings_for(cells);
  const std::int32_t width = kLatticeSize >> halvings;
  const std::int32_t low = ((1 << halvings) - cells) / 2 * width + 1;
  Lattice lattice;
  lattice.step = extent > 0 ? extent / (cells * width - 2) : 1.0;
  lattice.step = std::max(lattice.step, std::numeric_limits<double>::min());
  for (;;) {
    lattice.origin = bounds.min - Vec3::Constant(lattice.step * low);
    if (is_within_margins(lattice, bounds)) return lattice;
    lattice.step *= 2;
  }
}

/// Converts a point from lattice to model coordinates, rounded to the 32-bit floats in which meshes
/// are handed out.
inline Vec3 single_precision(const Lattice& lattice, const Vec3& point) {
  return lattice.to_model(point).cast<float>().cast<double>();
}

}  // namespace kdm
