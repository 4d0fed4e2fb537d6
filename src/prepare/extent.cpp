// SPDX-License-Identifier: MIT
// Leaves the smallest parts out, one after the other, as long as they hold next to no area.
#include "prepare/extent.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/triangle.h"
#include "mesh/boxes.h"
#include "mesh/disjoint_sets.h"
#include "mesh/scale.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

// The share of the area that stray parts may hold together.
constexpr double kMostArea = 1e-3;
// The share of the diagonal that may be left without them.
constexpr double kMostDiagonal = 0.5;

struct Part {
  Box bounds;
  double area = 0;
};

double diagonal_of(const Box& box) { return (box.max - box.min).norm(); }

std::vector<Part> find_parts(std::span<const Triangle> triangles,
                             const std::vector<Vec3>& positions) {
  DisjointSets sets(positions.size());
  for (const Triangle& t : triangles) {
    sets.join(t[0], t[1]);
    sets.join(t[0], t[2]);
  }
  std::vector<Index> number(positions.size(), kNone);
  std::vector<Part> parts;
  for (const Triangle& t : triangles) {
    Index& part = number[sets.find(t[0])];
    if (part == kNone) {
      part = static_cast<Index>(parts.size());
      parts.emplace_back();
    }
    for (const Index p : t) grow(parts[part].bounds, positions[p]);
    parts[part].area +=
        doubled_area_vector(positions[t[0]], positions[t[1]], positions[t[2]]).norm();
  }
  return parts;
}

}  // namespace

Extent find_extent(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                   const Topology& topology, const Box& bounds) {
  Extent extent{diagonal_of(bounds), 0};
  if (topology.components < 2) return extent;  // one part, joined by edges
  const ScaledPositions scaled = scale_to_one(points, triangles);
  std::vector<Part> parts = find_parts(triangles, scaled.positions);
  sort_by(parts, [](const Part& a, const Part& b) { return a.area < b.area; });
  const double whole =
      std::accumulate(parts.begin(), parts.end(), 0.0,
                      [](double sum, const Part& part) { return sum + part.area; });
  double left_out = 0;
  std::size_t first = 0;  // of the parts that stay
  while (first + 1 < parts.size() && left_out + parts[first].area < kMostArea * whole) {
    left_out += parts[first++].area;
  }
  if (first == 0) return extent;
  Box rest = parts[first].bounds;
  for (std::size_t i = first + 1; i < parts.size(); ++i) grow(rest, parts[i].bounds);
  const double diagonal = std::ldexp(diagonal_of(rest), scaled.exponent);
  if (diagonal < kMostDiagonal * extent.diagonal) return {diagonal, static_cast<Index>(first)};
  return extent;
}

}  // namespace kdm
