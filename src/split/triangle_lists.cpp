// SPDX-License-Identifier: MIT
// Division of a cell's list of triangles by a splitting plane.
#include "split/triangle_lists.h"

#include <algorithm>
#include <cmath>

#include "geometry/predicates.h"

namespace kdm {
namespace {

// Bounds are widened by this many lattice units. The arithmetic behind them is rounded, with errors
// far smaller than this. So a list may hold a triangle too many, but never one too few.
constexpr double kRoundingSlack = 1e-3;

// Returns a lattice coordinate that is certainly not above x. Lattice coordinates are not negative,
// so that truncation rounds down.
std::int32_t round_down(double x) { return static_cast<std::int32_t>(x - kRoundingSlack); }
// Returns a lattice coordinate that is certainly not below x.
std::int32_t round_up(double x) { return static_cast<std::int32_t>(x + kRoundingSlack) + 1; }

// Bounds along an axis; at first of nothing.
struct Interval {
  std::int32_t lo = 4 * kLatticeSize;  // beyond all coordinates
  std::int32_t hi = -4 * kLatticeSize;

  void extend(std::int32_t low, std::int32_t high) {
    lo = std::min(lo, low);
    hi = std::max(hi, high);
  }
};

// Tells whether the triangle's plane may meet the bounds of the part. An answer "no" is certain.
bool plane_meets(const LatticeTriangle& t, const ListEntry& part) {
  const auto normal = area_vector(t);
  // Heights over the plane, times the length of the normal: of the middle of the bounds, and of
  // their highest corner over that middle.
  double middle_height = 0;
  double corner_height = 0;
  double normal_size = 0;
  for (int i = 0; i < 3; ++i) {
    const auto n = static_cast<double>(normal[i]);
    middle_height += n * (0.5 * (part.lo[i] + part.hi[i]) - t[0][i]);
    corner_height += std::abs(n) * (0.5 * (part.hi[i] - part.lo[i]));
    normal_size += std::abs(n);
  }
  return std::abs(middle_height) <= corner_height + kRoundingSlack * normal_size;
}

// Tells whether the triangle may have a part within the bounds. It has one if one of its corners
// lies there; otherwise its plane must meet the bounds.
bool may_meet(const LatticeTriangle& t, const ListEntry& part) {
  for (int i = 0; i < 3; ++i) {
    if (part.lo[i] > part.hi[i]) return false;
  }
  for (const LatticePoint& p : t) {
    bool within = true;
    for (int i = 0; i < 3; ++i) within &= p[i] >= part.lo[i] && p[i] <= part.hi[i];
    if (within) return true;
  }
  return plane_meets(t, part);
}

}  // namespace

ListEntry whole_entry(TriangleId triangle, const LatticeTriangle& t) {
  ListEntry entry;
  entry.triangle = triangle;
  for (int k = 0; k < 3; ++k) {
    entry.lo[k] = std::min({t[0][k], t[1][k], t[2][k]});
    entry.hi[k] = std::max({t[0][k], t[1][k], t[2][k]});
  }
  return entry;
}

TriangleLists::TriangleLists(const std::vector<LatticeTriangle>& triangles)
    : triangles_(triangles) {
  make_room(3 * triangles.size());
  for (const LatticeTriangle& t : triangles) {
    arena_[root_size_] = whole_entry(root_size_, t);
    ++root_size_;
  }
  size_ = root_size_;
}

TriangleLists::TriangleLists(const std::vector<LatticeTriangle>& triangles,
                             std::span<const ListEntry> entries)
    : triangles_(triangles), root_size_(static_cast<Index>(entries.size())) {
  make_room(3 * entries.size());
  std::copy(entries.begin(), entries.end(), arena_.get());
  size_ = root_size_;
}

void TriangleLists::make_room(std::size_t more_entries) {
  if (size_ + more_entries <= capacity_) return;
  const std::size_t capacity = std::max(size_ + more_entries, 2 * capacity_);
  std::unique_ptr<ListEntry[]> larger(new ListEntry[capacity]);
  std::copy(arena_.get(), arena_.get() + size_, larger.get());
  arena_ = std::move(larger);
  capacity_ = capacity;
}

TriangleLists::Children TriangleLists::divide(ListRange parent, int axis, std::int32_t value) {
  straddlers_.clear();
  above_.clear();
  make_room(2 * std::size_t{parent.size()});
  const Index first_below = size_;
  for (Index i = parent.begin; i < parent.end; ++i) {
    const ListEntry& entry = arena_[i];
    if (entry.hi[axis] <= value) {
      arena_[size_++] = entry;
    } else if (entry.lo[axis] > value) {
      above_.push_back(entry);
    } else {
      straddlers_.push_back(i);
      divide_straddler(entry, axis, value);
    }
  }
  const Index first_above = size_;
  std::copy(above_.begin(), above_.end(), arena_.get() + size_);
  size_ += static_cast<Index>(above_.size());
  return {{first_below, first_above}, {first_above, size_}};
}

// The triangle's part on one side of the plane lies within the bounds of its corners there and of
// the two points where its outline crosses the plane. It also lies within the bounds of the entry.
DividedEntry divide_entry(const LatticeTriangle& t, const ListEntry& entry, int axis,
                          std::int32_t value) {
  const int u = next_axis(axis);
  const int v = previous_axis(axis);
  Interval below_w, below_u, below_v;  // of the corners below the plane: along the axis, across it
  Interval above_w, above_u, above_v;
  Interval cut_u, cut_v;  // of the points in the plane
  for (int i = 0; i < 3; ++i) {
    const LatticePoint& a = t[i];
    const LatticePoint& b = t[i == 2 ? 0 : i + 1];
    if (a[axis] <= value) {
      // The plane lies infinitely little above its value. So a corner at the value lies below the
      // plane, and the part below extends a little from there along the sides that rise.
      const std::int32_t reach = a[axis] == value ? 1 : 0;
      below_w.extend(a[axis] - reach, a[axis] + reach);
      below_u.extend(a[u] - reach, a[u] + reach);
      below_v.extend(a[v] - reach, a[v] + reach);
    }
    if (a[axis] >= value) {
      above_w.extend(a[axis], a[axis]);
      above_u.extend(a[u], a[u]);
      above_v.extend(a[v], a[v]);
    }
    if ((a[axis] < value) == (b[axis] < value) || a[axis] == value || b[axis] == value) continue;
    const double share = static_cast<double>(value - a[axis]) / (b[axis] - a[axis]);
    const double at_u = a[u] + share * (b[u] - a[u]);
    const double at_v = a[v] + share * (b[v] - a[v]);
    cut_u.extend(round_down(at_u), round_up(at_u));
    cut_v.extend(round_down(at_v), round_up(at_v));
  }
  const auto part = [&](const Interval& along, Interval across_u, Interval across_v) {
    across_u.extend(cut_u.lo, cut_u.hi);
    across_v.extend(cut_v.lo, cut_v.hi);
    ListEntry bounded;
    bounded.triangle = entry.triangle;
    bounded.lo[axis] = std::max(along.lo, entry.lo[axis]);
    bounded.hi[axis] = std::min(along.hi, entry.hi[axis]);
    bounded.lo[u] = std::max(across_u.lo, entry.lo[u]);
    bounded.hi[u] = std::min(across_u.hi, entry.hi[u]);
    bounded.lo[v] = std::max(across_v.lo, entry.lo[v]);
    bounded.hi[v] = std::min(across_v.hi, entry.hi[v]);
    return bounded;
  };
  DividedEntry divided;
  divided.part = {part(below_w, below_u, below_v), part(above_w, above_u, above_v)};
  divided.part[0].hi[axis] = value;
  divided.part[1].lo[axis] = value;
  for (int side = 0; side < 2; ++side) divided.meets[side] = may_meet(t, divided.part[side]);
  return divided;
}

// Adds the triangle of an entry that reaches both sides of the plane to the lists of both children,
// except where it has no part in a child.
void TriangleLists::divide_straddler(const ListEntry& entry, int axis, std::int32_t value) {
  const DividedEntry divided = divide_entry(triangles_[entry.triangle], entry, axis, value);
  if (divided.meets[0]) arena_[size_++] = divided.part[0];
  if (divided.meets[1]) above_.push_back(divided.part[1]);
}

}  // namespace kdm
