// SPDX-License-Identifier: MIT
// Keeps the half-edges linked while edges are collapsed and flipped.
#include "reduce/half_edges.h"

#include <algorithm>

#include "kdmanifold/error.h"
#include "mesh/topology.h"
#include "text/compose.h"

namespace kdm {

HalfEdges::HalfEdges(std::span<const Triangle> triangles, Index vertices)
    : leaving_(vertices, kNone), living_(static_cast<Index>(triangles.size())) {
  Topology topology = build_topology(triangles, vertices);
  if (topology.non_manifold_edges > 0) {
    throw Error(ErrorCode::kInvalidMesh,
                compose("triangle {} has an edge with more than two triangles: only 2-manifold "
                        "meshes can be reduced; make it manifold first",
                        triangle_of(topology.non_manifold_sides[0])));
  }
  opposite_ = std::move(topology.opposite);
  start_.reserve(3 * triangles.size());
  for (const Triangle& t : triangles) start_.insert(start_.end(), t.begin(), t.end());
  for (SideId h = 0; h < start_.size(); ++h) {
    if (leaving_[start_[h]] == kNone || opposite_[h] == kNone) leaving_[start_[h]] = h;
  }
  check_fans();
}

VertexId PartNumbers::vertex(VertexId whole) const {
  return static_cast<VertexId>(std::lower_bound(vertices.begin(), vertices.end(), whole) -
                               vertices.begin());
}

SideId PartNumbers::side(SideId whole) const {
  if (whole == kNone) return kNone;
  const TriangleId t = triangle_of(whole);
  const auto at = std::lower_bound(triangles.begin(), triangles.end(), t);
  if (at == triangles.end() || *at != t) return kNone;
  return 3 * static_cast<Index>(at - triangles.begin()) + corner_of(whole);
}

HalfEdges::HalfEdges(const HalfEdges& whole, const PartNumbers& part)
    : leaving_(part.vertices.size(), kNone), living_(static_cast<Index>(part.triangles.size())) {
  for (const TriangleId t : part.triangles) {
    for (SideId h = 3 * t; h < 3 * t + 3; ++h) {
      const SideId back = part.side(whole.opposite_[h]);
      const VertexId v = part.vertex(whole.start_[h]);
      if (leaving_[v] == kNone || back == kNone) leaving_[v] = static_cast<SideId>(start_.size());
      start_.push_back(v);
      opposite_.push_back(back);
    }
  }
}

void HalfEdges::put_back(const HalfEdges& copied, const PartNumbers& part, const Marks& owned,
                         const Marks& inside) {
  for (SideId h = 0; h < copied.start_.size(); ++h) {
    const SideId back = copied.opposite_[h];
    const bool is_owned = owned.test(triangle_of(h));
    if (is_owned) start_[part.whole_side(h)] = part.whole_vertex(copied.start_[h]);
    // A neighbour beyond keeps its corners, but what it meets there may have been turned.
    if (is_owned || (back != kNone && owned.test(triangle_of(back)))) {
      opposite_[part.whole_side(h)] = part.whole_side(back);
    }
  }
  for (VertexId v = 0; v < copied.leaving_.size(); ++v) {
    if (inside.test(v)) leaving_[part.vertices[v]] = part.whole_side(copied.leaving_[v]);
  }
}

// Every corner of a vertex must be met on the walk round it.
void HalfEdges::check_fans() const {
  std::vector<Index> corners(vertices(), 0);
  for (const VertexId v : start_) ++corners[v];
  for (VertexId v = 0; v < vertices(); ++v) {
    if (leaving_[v] == kNone) continue;
    Index met = 0;
    for_each_leaving(v, [&](SideId) { ++met; });
    if (met == corners[v]) continue;
    throw Error(
        ErrorCode::kInvalidMesh,
        compose("the triangles of vertex {} do not form one fan: only 2-manifold meshes can "
                "be reduced; make it manifold first",
                v));
  }
}

void HalfEdges::join(SideId a, SideId b) {
  if (a != kNone) opposite_[a] = b;
  if (b != kNone) opposite_[b] = a;
}

void HalfEdges::remove_triangle(TriangleId t) {
  for (SideId h = 3 * t; h < 3 * t + 3; ++h) {
    start_[h] = kNone;
    opposite_[h] = kNone;
  }
  --living_;
}

// Finds the vertex's half-edge from which a walk meets all its triangles, from one of them.
void HalfEdges::settle(VertexId v, SideId h) {
  leaving_[v] = h;
  for (SideId back = opposite_[h]; back != kNone; back = opposite_[h]) {
    h = next_side(back);
    if (h == leaving_[v]) return;
  }
  leaving_[v] = h;
}

void HalfEdges::collapse(SideId h) {
  const VertexId kept = start_[h];
  const VertexId removed = end(h);
  const std::array<SideId, 2> sides = {h, opposite_[h]};
  for_each_leaving(removed, [&](SideId leaving) { start_[leaving] = kept; });
  leaving_[removed] = kNone;
  for (const SideId side : sides) {
    if (side == kNone) continue;
    const SideId previous = previous_side(side);
    const VertexId tip = start_[previous];
    // Half-edges of the neighbours that become opposites: one from the tip and one to it.
    const SideId from_tip = opposite_[next_side(side)];
    const SideId to_tip = opposite_[previous];
    join(from_tip, to_tip);
    remove_triangle(triangle_of(side));
    settle(tip, from_tip != kNone ? from_tip : next_side(to_tip));
    leaving_[kept] = to_tip != kNone ? to_tip : next_side(from_tip);
  }
  settle(kept, leaving_[kept]);
}

void HalfEdges::flip(SideId h) {
  // Triangle (a, b, c) of h becomes (a, d, c), and (b, a, d) beyond it becomes (b, c, d).
  const SideId back = opposite_[h];
  const SideId from_b = next_side(h);
  const SideId from_a = next_side(back);
  const VertexId a = start_[h];
  const VertexId b = start_[back];
  if (leaving_[a] == from_a) leaving_[a] = h;
  if (leaving_[b] == from_b) leaving_[b] = back;
  start_[from_b] = start_[previous_side(back)];
  start_[from_a] = start_[previous_side(h)];
  join(h, opposite_[from_a]);
  join(back, opposite_[from_b]);
  join(from_a, from_b);
}

}  // namespace kdm
