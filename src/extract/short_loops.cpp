// SPDX-License-Identifier: MIT
// Finds short loops by shortest paths from vertices at which loops can pass.
#include "extract/short_loops.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "mesh/sides.h"
#include "mesh/topology.h"

namespace kdm {
namespace {

constexpr double kUnreached = std::numeric_limits<double>::infinity();

// How far searches go, as a part of the length asked for: further than loops that are short enough,
// so that one search speaks for the vertices near its source.
constexpr double kSearchRadius = 0.75;

}  // namespace

ShortLoops::ShortLoops(const std::vector<Vec3>& positions, std::span<const Triangle> triangles)
    : positions_(positions),
      triangles_(triangles),
      opposite_(build_topology(triangles, static_cast<Index>(positions.size())).opposite),
      sides_(positions.size(),
             [&](const auto& put) {
               for (SideId side = 0; side < 3 * triangles.size(); ++side) put(start(side), side);
             }),
      kind_(3 * triangles.size(), 0),
      settled_(positions.size()),
      distance_(positions.size(), kUnreached),
      way_(positions.size(), kNone),
      way_kind_(positions.size(), 0) {
  find_basis();
}

VertexId ShortLoops::start(SideId side) const {
  return triangles_[triangle_of(side)][corner_of(side)];
}
VertexId ShortLoops::end(SideId side) const { return start(next_side(side)); }

// Edges in a tree of vertices have kind 0, since they close no loop; those that are in neither tree
// have one of their own; and the three of a triangle add up to 0.
void ShortLoops::find_basis() {
  Marks in_tree(kind_.size());
  grow_vertex_trees(in_tree);
  const std::vector<SideId> entered = grow_face_trees(in_tree);
  Index left = 0;
  for (SideId side = 0; side < kind_.size(); ++side) {
    const SideId other = opposite_[side];
    if (in_tree.test(side) || other == kNone || other < side) continue;
    kind_[side] = kind_[other] = mixed_bits(left++);
  }
  handles_ = left / 2;
  for (std::size_t i = entered.size(); i-- > 0;) {
    const SideId side = entered[i];
    kind_[side] = kind_[next_side(side)] ^ kind_[previous_side(side)];
    kind_[opposite_[side]] = kind_[side];
  }
}

// Marks the sides of trees that reach all vertices.
void ShortLoops::grow_vertex_trees(Marks& tree) const {
  Marks seen(positions_.size());
  std::vector<VertexId> queue;
  queue.reserve(positions_.size());
  for (VertexId root = 0; root < positions_.size(); ++root) {
    if (seen.test_and_set(root)) continue;
    queue.push_back(root);
    for (std::size_t i = queue.size() - 1; i < queue.size(); ++i) {
      for (const SideId side : sides_.of(queue[i])) {
        if (opposite_[side] == kNone || seen.test_and_set(end(side))) continue;
        tree.set(side);
        tree.set(opposite_[side]);
        queue.push_back(end(side));
      }
    }
  }
}

// Marks the sides that trees cross which reach all triangles and cross no marked side. Returns for
// each triangle but the roots the side through which it was entered, in the order of entering.
std::vector<SideId> ShortLoops::grow_face_trees(Marks& tree) const {
  Marks seen(triangles_.size());
  std::vector<SideId> entered;
  std::vector<TriangleId> queue;
  queue.reserve(triangles_.size());
  for (TriangleId root = 0; root < triangles_.size(); ++root) {
    if (seen.test_and_set(root)) continue;
    queue.push_back(root);
    for (std::size_t i = queue.size() - 1; i < queue.size(); ++i) {
      for (SideId side = 3 * queue[i]; side < 3 * queue[i] + 3; ++side) {
        const SideId other = opposite_[side];
        if (other == kNone || tree.test(side) || seen.test_and_set(triangle_of(other))) continue;
        tree.set(side);
        tree.set(other);
        queue.push_back(triangle_of(other));
        entered.push_back(other);
      }
    }
  }
  return entered;
}

// A loop that divides nothing has an edge whose kind is not 0, so it passes a vertex of one. If the
// shortest loop through a vertex has length l, there is none shorter than l - 2d through a vertex
// at a distance of d.
std::vector<ShortLoop> ShortLoops::find(double below, const KindSpan& passed_over) {
  limited_ = false;
  std::vector<ShortLoop> loops;
  if (passed_over.size() == 2 * std::size_t{handles_}) return loops;
  Marks covered(positions_.size());
  for (VertexId source = 0; source < positions_.size(); ++source) {
    const auto crossing = [&](SideId side) { return kind_[side] != 0; };
    const auto sides = sides_.of(source);
    if (covered.test(source) || std::none_of(sides.begin(), sides.end(), crossing)) continue;
    const double radius = kSearchRadius * below;
    const Found found = search(source, radius, passed_over);
    const bool is_short = found.length < below;
    limited_ = limited_ || found.limited || (!is_short && found.length < kUnreached);
    const double reach = (std::min(found.length, 2 * radius) - below) / 2;
    covered.set(source);
    for (const VertexId v : order_) {
      if (is_short || distance_[v] <= reach) covered.set(v);
    }
    if (is_short) loops.push_back(narrowed(loop_through(found), passed_over));
  }
  return loops;
}

// Looks for the shortest loop through the source, up to twice the radius (Dijkstra's algorithm).
ShortLoops::Found ShortLoops::search(VertexId source, double radius, const KindSpan& passed_over) {
  for (const VertexId v : order_) settled_.clear(v);
  for (const VertexId v : reached_) distance_[v] = kUnreached;
  order_.clear();
  reached_.assign(1, source);
  distance_[source] = 0;
  way_[source] = kNone;
  way_kind_[source] = 0;
  Found best{kUnreached};
  using Entry = std::pair<double, VertexId>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  queue.push({0, source});
  while (!queue.empty()) {
    const auto [far, v] = queue.top();
    queue.pop();
    if (settled_.test(v)) continue;
    if (2 * far >= best.length) break;
    best.limited = far > radius;
    if (best.limited) break;
    settled_.set(v);
    order_.push_back(v);
    look_across(v, passed_over, best);
    for (const SideId side : sides_.of(v)) {
      const VertexId to = end(side);
      const double along = far + length(side);
      if (!(along < distance_[to])) continue;
      if (distance_[to] == kUnreached) reached_.push_back(to);
      distance_[to] = along;
      way_[to] = side;
      way_kind_[to] = way_kind_[v] ^ kind_[side];
      queue.push({along, to});
    }
  }
  return best;
}

// Looks whether an edge from v to a settled vertex closes a loop that divides nothing.
void ShortLoops::look_across(VertexId v, const KindSpan& passed_over, Found& best) const {
  for (const SideId side : sides_.of(v)) {
    const VertexId to = end(side);
    if (!settled_.test(to)) continue;
    const std::uint64_t kind = kind_across(side);
    if (passed_over.contains(kind)) continue;
    const double whole = distance_[v] + length(side) + distance_[to];
    if (whole < best.length) best = {whole, side, false};
  }
}

// Leaves out what both ways from the source have in common.
ShortLoop ShortLoops::loop_through(const Found& found) const {
  const auto way_to = [&](VertexId v) {
    std::vector<VertexId> way{v};
    while (way_[v] != kNone) way.push_back(v = start(way_[v]));
    return way;
  };
  std::vector<VertexId> there = way_to(start(found.side));
  std::vector<VertexId> back = way_to(end(found.side));
  VertexId meeting = kNone;
  while (!there.empty() && !back.empty() && there.back() == back.back()) {
    meeting = there.back();
    there.pop_back();
    back.pop_back();
  }
  ShortLoop loop;
  loop.kind = kind_across(found.side);
  loop.length = found.length - 2 * distance_[meeting];
  loop.vertices.assign(1, meeting);
  loop.vertices.insert(loop.vertices.end(), there.rbegin(), there.rend());
  loop.vertices.insert(loop.vertices.end(), back.begin(), back.end());
  return loop;
}

// Goes on with the shortest loop through any vertex of the loop until that is none shorter.
ShortLoop ShortLoops::narrowed(ShortLoop loop, const KindSpan& passed_over) {
  constexpr double kShorter = 1 - 1e-9;
  for (bool shorter = true; shorter;) {
    shorter = false;
    for (const VertexId v : std::vector<VertexId>(loop.vertices)) {
      const Found found = search(v, loop.length / 2, passed_over);
      if (!(found.length < kShorter * loop.length)) continue;
      loop = loop_through(found);
      shorter = true;
    }
  }
  return loop;
}

double ShortLoops::length(SideId side) const {
  return (positions_[end(side)] - positions_[start(side)]).norm();
}

std::uint64_t ShortLoops::kind_across(SideId side) const {
  return way_kind_[start(side)] ^ way_kind_[end(side)] ^ kind_[side];
}

}  // namespace kdm
