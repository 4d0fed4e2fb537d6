// SPDX-License-Identifier: MIT
// Partition of a cell's triangles by a plane.
#include "build/triangle_lists.h"

#include <algorithm>
#include <cmath>

#include "geometry/predicates.h"

namespace kdm {
namespace {

// Bounds come from rounded arithmetic whose error is far below this, and are widened by it: a
// list may hold a triangle too many, never one too few.
constexpr double kSlack = 1e-3;

struct RealBounds {
  std::array<double, 3> lo;
  std::array<double, 3> hi;

  void add(const std::array<double, 3>& p) {
    for (int i = 0; i < 3; ++i) {
      lo[i] = std::min(lo[i], p[i]);
      hi[i] = std::max(hi[i], p[i]);
    }
  }
};

constexpr double kFar = 4.0 * kLatticeSize;
constexpr RealBounds kNothing{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};

// Intersects `box` with `bounds`, outwards; false if nothing is left.
bool shrink(LatticeBox& box, const RealBounds& bounds) {
  for (int i = 0; i < 3; ++i) {
    box.lo[i] = std::max(box.lo[i], static_cast<std::int32_t>(std::floor(bounds.lo[i] - kSlack)));
    box.hi[i] = std::min(box.hi[i], static_cast<std::int32_t>(std::ceil(bounds.hi[i] + kSlack)));
    if (box.lo[i] > box.hi[i]) return false;
  }
  return true;
}

// May the triangle's plane meet the box?
bool plane_meets(const std::array<double, 3>& normal, const LatticePoint& point,
                 const LatticeBox& box) {
  double middle = 0;
  double reach = 0;
  double size = 0;
  for (int i = 0; i < 3; ++i) {
    middle += normal[i] * (0.5 * (box.lo[i] + box.hi[i]) - point[i]);
    reach += std::abs(normal[i]) * (0.5 * (box.hi[i] - box.lo[i]));
    size += std::abs(normal[i]);
  }
  return std::abs(middle) <= reach + kSlack * size;
}

}  // namespace

TriangleLists::TriangleLists(const std::vector<LatticeTriangle>& triangles)
    : triangles_(triangles) {
  arena_.reserve(3 * triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const LatticeTriangle& t = triangles[i];
    ListEntry entry{static_cast<Index>(i), {t[0], t[0]}};
    for (int k = 0; k < 3; ++k) {
      entry.bounds.lo[k] = std::min({t[0][k], t[1][k], t[2][k]});
      entry.bounds.hi[k] = std::max({t[0][k], t[1][k], t[2][k]});
    }
    arena_.push_back(entry);
  }
  all_ = static_cast<Index>(arena_.size());
}

TriangleLists::Children TriangleLists::divide(ListRange parent, int axis, std::int32_t value) {
  straddlers_.clear();
  above_.clear();
  const auto first_below = static_cast<Index>(arena_.size());
  for (Index i = parent.begin; i < parent.end; ++i) {
    const ListEntry entry = arena_[i];  // a copy: the arena may move
    if (entry.bounds.hi[axis] <= value) {
      arena_.push_back(entry);
    } else if (entry.bounds.lo[axis] > value) {
      above_.push_back(entry);
    } else {
      straddlers_.push_back(i);
      divide_straddler(entry, axis, value);
    }
  }
  const auto first_above = static_cast<Index>(arena_.size());
  arena_.insert(arena_.end(), above_.begin(), above_.end());
  return {{first_below, first_above}, {first_above, static_cast<Index>(arena_.size())}};
}

// The part on each side lies within the bounds of the triangle's corners on that side and of the
// two points where its outline crosses the plane, and within the parent's bounds.
void TriangleLists::divide_straddler(const ListEntry& entry, int axis, std::int32_t value) {
  const LatticeTriangle& t = triangles_[entry.triangle];
  const int u = next_axis(axis);
  const int v = previous_axis(axis);
  RealBounds below = kNothing;
  RealBounds above = kNothing;
  for (int i = 0; i < 3; ++i) {
    const LatticePoint& a = t[i];
    const LatticePoint& b = t[i == 2 ? 0 : i + 1];
    const std::array<double, 3> corner{static_cast<double>(a[0]), static_cast<double>(a[1]),
                                       static_cast<double>(a[2])};
    if (a[axis] <= value) below.add(corner);
    if (a[axis] >= value) above.add(corner);
    if ((a[axis] < value && b[axis] > value) || (a[axis] > value && b[axis] < value)) {
      const double s = static_cast<double>(value - a[axis]) / (b[axis] - a[axis]);
      std::array<double, 3> crossing{};
      crossing[axis] = value;
      crossing[u] = a[u] + s * (b[u] - a[u]);
      crossing[v] = a[v] + s * (b[v] - a[v]);
      below.add(crossing);
      above.add(crossing);
    }
  }
  ListEntry low = entry;
  low.bounds.hi[axis] = value;
  ListEntry high = entry;
  high.bounds.lo[axis] = value;
  const bool in_low = shrink(low.bounds, below);
  const bool in_high = shrink(high.bounds, above);
  const auto area = area_vector(t);
  const std::array<double, 3> normal{static_cast<double>(area[0]), static_cast<double>(area[1]),
                                     static_cast<double>(area[2])};
  if (in_low && plane_meets(normal, t[0], low.bounds)) arena_.push_back(low);
  if (in_high && plane_meets(normal, t[0], high.bounds)) above_.push_back(high);
}

}  // namespace kdm
