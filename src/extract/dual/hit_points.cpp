// SPDX-License-Identifier: MIT
// Computes the points where the surface crosses the grid's edges.
#include <algorithm>
#include <cmath>

#include "extract/dual/grid_view.h"
#include "grid/splitting_edges.h"

namespace kdm {
namespace {

// Hits of an edge are moved this far from each other and from grid vertices where there is room, in
// lattice units: enough to be told apart in 32 bits.
constexpr double kBetweenHits = 2;
constexpr double kFromEnds = 1.0 / 3;

// An interval of a grid edge, lattice coordinates.
struct Stretch {
  double lo;
  double hi;
  bool operator==(const Stretch&) const = default;
};

// Returns the stretch of the hit's edge that all leaves round the hit have in common. No grid
// vertex lies within it.
Stretch stretch_round(const GridData& grid, std::span<const LatticeBox> boxes, Index hit,
                      int axis) {
  std::int32_t lo = 0;
  std::int32_t hi = kLatticeSize;
  const auto narrow = [&](Index of_hit) {
    for (Index h = 3 * of_hit; h < 3 * of_hit + 3; ++h) {
      const LatticeBox& box = boxes[grid.start_leaf(h)];
      lo = std::max(lo, box.lo[axis]);
      hi = std::min(hi, box.hi[axis]);
    }
  };
  narrow(hit);
  // Coincident edges have the same hits, which must go to the same places.
  for (Index h = 3 * hit; h < 3 * hit + 3; ++h) {
    if (grid.crosses_strip(h) && grid.opposite[h] != kNone) narrow(grid.opposite[h] / 3);
  }
  return {static_cast<double>(lo), static_cast<double>(hi)};
}

// Moves hits of one edge that lie close together or at a grid vertex.
void keep_apart(const GridData& grid, std::span<const LatticeBox> boxes, HitRange hits, int axis,
                std::vector<Vec3>& points) {
  const HitId begin = hits.first;
  const HitId end = hits.beyond;
  const auto at = [&](Index h) -> double& { return points[h][axis]; };
  const auto tight = [&](Index h) {
    constexpr double kNear = 1.0 / 8;
    return std::abs(at(h) - std::floor(at(h) + 0.5)) < kNear ||
           (h > begin && at(h) - at(h - 1) < kBetweenHits);
  };
  Index first = begin;
  while (first < end) {
    if (!tight(first) && (first + 1 == end || !tight(first + 1))) {
      ++first;
      continue;
    }
    const Stretch stretch = stretch_round(grid, boxes, first, axis);
    while (first > begin && at(first - 1) >= stretch.lo &&
           stretch_round(grid, boxes, first - 1, axis) == stretch) {
      --first;
    }
    Index next = first + 1;
    while (next < end && stretch_round(grid, boxes, next, axis) == stretch) ++next;
    const double room = (stretch.hi - stretch.lo) / (next - first + 1);
    const double between = std::min(kBetweenHits, room);
    const double from_ends = std::min(kFromEnds, room);
    for (Index h = first; h < next; ++h) {
      at(h) = std::max(at(h), h == first ? stretch.lo + from_ends : at(h - 1) + between);
    }
    for (Index h = next; h-- > first;) {
      at(h) = std::min(at(h), h + 1 == next ? stretch.hi - from_ends : at(h + 1) - between);
    }
    first = next;
  }
}

}  // namespace

std::vector<Vec3> hit_points(const GridData& grid, std::span<const LatticeBox> boxes, bool apart) {
  std::vector<Vec3> points(grid.hits.size());
  for_each_splitting_edge(grid, boxes, [&](const SplittingEdge& edge) {
    Vec3 point = to_vec3(edge.low());
    for (const HitId h : edge.hits) {
      point[edge.axis] = real_position(grid.hits[h].position);
      points[h] = point;
    }
    if (apart) keep_apart(grid, boxes, edge.hits, edge.axis, points);
  });
  return points;
}

}  // namespace kdm
