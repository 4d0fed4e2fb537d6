// SPDX-License-Identifier: MIT
// Pairs the sides on an edge greedily by the angle between their triangles.
#include "prepare/non_manifold_edges.h"

#include <algorithm>
#include <array>

#include "geometry/triangle.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

struct Side {
  PointId low;
  PointId high;
  SideId number;
  bool forward;  // runs from `low` to `high`

  bool same_edge(const Side& other) const { return low == other.low && high == other.high; }
};

// Returns the unit vector that leads from the edge into the triangle and stands upright on the
// edge; zero if the triangle has no area.
Vec3 inwards(const Triangle& t, int corner, const std::vector<Vec3>& points) {
  const int next = next_corner(corner);
  const Vec3& a = points[t[corner]];
  const Vec3 along = points[t[next]] - a;
  const Vec3 across = points[t[next_corner(next)]] - a;
  return normalized_or_zero(across * along.squaredNorm() - along * along.dot(across));
}

// Two sides that run against each other, with the cosine of the angle between their triangles: -1
// where the surface goes straight on.
struct Candidate {
  double cosine;
  SideId forward;
  SideId backward;

  bool operator<(const Candidate& other) const {
    if (cosine != other.cosine) return cosine < other.cosine;
    return std::array{forward, backward} < std::array{other.forward, other.backward};
  }
};

// Limits the candidates of one edge, which are the square of its sides: where thousands of faces
// coincide, they would not come to an end.
constexpr std::ptrdiff_t kMostSides = 64;

void pair_edge(std::span<const Side> edge, std::span<const Triangle> triangles,
               const std::vector<Vec3>& points, std::vector<SideId>& opposite) {
  const auto direction_of = [&](const Side& s) {
    return inwards(triangles[triangle_of(s.number)], corner_of(s.number), points);
  };
  std::vector<Candidate> candidates;
  for (const Side& a : edge) {
    opposite[a.number] = kNone;
    if (!a.forward) continue;
    const Vec3 direction = direction_of(a);
    for (const Side& b : edge) {
      if (!b.forward) candidates.push_back({direction.dot(direction_of(b)), a.number, b.number});
    }
  }
  sort_up(candidates);
  for (const Candidate& c : candidates) {
    if (opposite[c.forward] != kNone || opposite[c.backward] != kNone) continue;
    opposite[c.forward] = c.backward;
    opposite[c.backward] = c.forward;
  }
}

}  // namespace

void pair_straightest(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                      Topology& topology) {
  std::vector<Side> sides;
  for (const SideId side : topology.non_manifold_sides) {
    const Triangle& t = triangles[triangle_of(side)];
    const PointId from = t[corner_of(side)];
    const PointId to = t[next_corner(corner_of(side))];
    sides.push_back({std::min(from, to), std::max(from, to), side, from < to});
  }
  for (auto first = sides.begin(); first != sides.end();) {
    auto last = first;
    while (last != sides.end() && last->same_edge(*first)) ++last;
    if (last - first <= kMostSides) {
      pair_edge({&*first, static_cast<std::size_t>(last - first)}, triangles, points,
                topology.opposite);
    }
    first = last;
  }
}

}  // namespace kdm
