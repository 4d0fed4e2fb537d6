// SPDX-License-Identifier: MIT
// Greedy pairing by the angle between triangles.
#include "prepare/crowded_edges.h"

#include <algorithm>
#include <array>

namespace kdm {
namespace {

struct Side {
  Index low;
  Index high;
  Index number;
  bool forward;

  bool same_edge(const Side& other) const { return low == other.low && high == other.high; }
};

// From the edge into the triangle, upright on the edge; zero without area.
Vec3 inwards(const Triangle& t, Index corner, const std::vector<Vec3>& points) {
  const Vec3& a = points[t[corner]];
  const Vec3 along = points[t[(corner + 1) % 3]] - a;
  const Vec3 across = points[t[(corner + 2) % 3]] - a;
  const Vec3 inward = across * along.squaredNorm() - along * along.dot(across);
  const double length = inward.norm();
  return length > 0 ? Vec3(inward / length) : Vec3(Vec3::Zero());
}

struct Candidate {
  double cosine;  // -1: straight on
  Index forward;
  Index backward;

  bool operator<(const Candidate& other) const {
    if (cosine != other.cosine) return cosine < other.cosine;
    return std::array{forward, backward} < std::array{other.forward, other.backward};
  }
};

// Edges of more sides keep the pairs they have: all with all would not end on coincident faces.
constexpr std::ptrdiff_t kMostSides = 64;

void pair_edge(std::span<const Side> edge, std::span<const Triangle> triangles,
               const std::vector<Vec3>& points, std::vector<Index>& twin) {
  std::vector<Candidate> candidates;
  for (const Side& a : edge) {
    twin[a.number] = kNone;
    if (!a.forward) continue;
    const Vec3 direction = inwards(triangles[a.number / 3], a.number % 3, points);
    for (const Side& b : edge) {
      if (b.forward) continue;
      const Vec3 other = inwards(triangles[b.number / 3], b.number % 3, points);
      candidates.push_back({direction.dot(other), a.number, b.number});
    }
  }
  std::sort(candidates.begin(), candidates.end());
  for (const Candidate& c : candidates) {
    if (twin[c.forward] != kNone || twin[c.backward] != kNone) continue;
    twin[c.forward] = c.backward;
    twin[c.backward] = c.forward;
  }
}

}  // namespace

void pair_straightest(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                      Topology& topology) {
  std::vector<Side> sides;
  for (const Index side : topology.crowded) {
    const Index from = triangles[side / 3][side % 3];
    const Index to = triangles[side / 3][next_corner(static_cast<int>(side % 3))];
    sides.push_back({std::min(from, to), std::max(from, to), side, from < to});
  }
  for (auto first = sides.begin(); first != sides.end();) {
    auto last = first;
    while (last != sides.end() && last->same_edge(*first)) ++last;
    if (last - first <= kMostSides) {
      pair_edge({&*first, static_cast<std::size_t>(last - first)}, triangles, points,
                topology.twin);
    }
    first = last;
  }
}

}  // namespace kdm
