// SPDX-License-Identifier: MIT
// Half-edges meet at their minimal faces: the first two that come to a face are linked. If a third
// one comes, the face is crowded, and its half-edges are paired when all have come.
#include "link/link_finest.h"

#include "grid/links.h"
#include "kdmanifold/error.h"
#include "link/match_face.h"
#include "link/outline.h"

namespace kdm {
namespace {

class FinestLinker {
 public:
  FinestLinker(const Surface& surface, std::span<const TriangleId> triangle_of_hit, Pairing pairing,
               const FinestGrid& finest, GridData& grid)
      : finest_(finest),
        tree_(finest.tree),
        cells_(finest.tree.cells()),
        matcher_(surface, triangle_of_hit, pairing, grid),
        grid_(grid),
        first_(3 * std::size_t{cells_.size()}, kNone) {}

  void run() {
    grid_.opposite.assign(3 * grid_.hits.size(), kNone);
    grid_.start.assign(3 * grid_.hits.size(), kNone);
    for (const TwinEdges& edges : finest_.edges) {
      const HitRange below = grid_.edge_hits(edges.below);
      const HitRange above = grid_.edge_hits(edges.above);
      for (Index i = 0; i < below.size(); ++i) link_twins(edges, below.first + i, above.first + i);
    }
    for (const Face& face : crowded_) match(face);
    check_pairs();
  }

 private:
  // A minimal face: the low side, across an axis, of the cell at a place.
  struct Face {
    LatticePoint place;
    int axis;
  };
  static constexpr Index kCrowded = kNone - 1;

  // Links the half-edges of two hits that are the same crossing of the surface with a grid line.
  // Round the line lie four leaves: a0 and a1 below the side plane, b0 and b1 above it; a0 and b0
  // below the splitting plane.
  void link_twins(const TwinEdges& edges, HitId a, HitId b) {
    LatticePoint place = edges.place;
    place[edges.axis] = cells_.place(edges.axis, floor_of(grid_.hits[a].position));
    const Leaf b1 = leaf_at(place);
    --place[edges.split_axis];
    const Leaf b0 = leaf_at(place);
    --place[edges.side_axis];
    const Leaf a0 = leaf_at(place);
    ++place[edges.split_axis];
    const Leaf a1 = leaf_at(place);
    set_starts(a, a0.cell, a1.cell, b0.cell, 2);
    set_starts(b, b0.cell, b1.cell, a1.cell, 1);
    join(3 * a + 2, 3 * b + 1);
    arrive(3 * a, a1, edges.split_axis);
    arrive(3 * b, b1, edges.split_axis);
    arrive(3 * a + 1, b0, edges.side_axis);
    arrive(3 * b + 2, b1, edges.side_axis);
  }

  struct Leaf {
    LatticePoint place;
    Index rank;  // in the set of finest cells
    CellId cell;
  };

  Leaf leaf_at(const LatticePoint& place) const {
    const Index rank = cells_.rank(cells_.code(place));
    return {place, rank, tree_.leaf(rank)};
  }

  // Notes where the half-edges of a hit start, one of which crosses a strip. v0, v1 and vn are the
  // leaves round it, in the names of grid_data.h.
  void set_starts(HitId hit, CellId v0, CellId v1, CellId vn, Index strip_slot) {
    const bool reversed = grid_.hits[hit].reversed();
    std::uint32_t* start = &grid_.start[3 * std::size_t{hit}];
    start[0] = reversed ? v1 : v0;
    start[1] = reversed ? v0 : vn;
    start[2] = reversed ? vn : v1;
    start[strip_slot] |= GridData::kStrip;
  }

  void join(HalfEdgeId a, HalfEdgeId b) {
    grid_.opposite[a] = b;
    grid_.opposite[b] = a;
  }

  // Takes note that a half-edge crosses the low side of a leaf across an axis.
  void arrive(HalfEdgeId half_edge, const Leaf& leaf, int axis) {
    HalfEdgeId& first = first_[3 * std::size_t{leaf.rank} + static_cast<std::size_t>(axis)];
    if (first == kNone) {
      first = half_edge;
    } else if (first != kCrowded && grid_.opposite[first] == kNone) {
      join(first, half_edge);
    } else if (first != kCrowded) {
      first = kCrowded;
      crowded_.push_back({leaf.place, axis});
    }
  }

  void match(const Face& crowded) {
    const MinimalFace face = minimal_face(crowded);
    collect_outline(grid_, face, outline_);
    matcher_(face, outline_, match_);
    ++grid_.stats.ambiguous_faces;
    if (match_.guessed) ++grid_.stats.guessed_faces;
    for (Index i = 0; i < outline_.size(); ++i) {
      grid_.opposite[outline_[i].half_edge] = outline_[match_.partner[i]].half_edge;
    }
  }

  // The half-edges of a pair must run against each other. Checked in release builds too: nothing
  // sound can follow.
  void check_pairs() const {
    for (HalfEdgeId h = 0; h < grid_.opposite.size(); ++h) {
      const HalfEdgeId other = grid_.opposite[h];
      if (other == kNone || grid_.start_leaf(h) == grid_.start_leaf(other)) {
        throw Error(ErrorCode::kInternal, "hits round a minimal face have no partners");
      }
    }
  }

  MinimalFace minimal_face(const Face& at) const {
    MinimalFace face;
    LatticePoint below = at.place;
    --below[at.axis];
    face.axis = at.axis;
    face.plane = cells_.plane(at.axis, at.place[at.axis]);
    face.below = leaf_at(below).cell;
    face.above = leaf_at(at.place).cell;
    for (int i = 0; i < 2; ++i) {
      // Sides 0 and 2 of the face run along its first axis, at the ends of its second.
      set_side(at, i, false, face.lo_key[i], face.edges[i == 0 ? 3 : 0]);
      set_side(at, i, true, face.hi_key[i], face.edges[i == 0 ? 1 : 2]);
    }
    return face;
  }

  // Sets the side at the low or high end of the face's first (i = 0) or second axis: its key, and
  // the hits on it. On a line in which the face's own plane is the one that splits deeper cells,
  // the edge is the split's own; else of the twins that of the split nearer to the face counts.
  void set_side(const Face& at, int i, bool high, std::int32_t& key, FaceEdge& edge) const {
    const int u = next_axis(at.axis);
    const int v = previous_axis(at.axis);
    const int across = i == 0 ? u : v;
    const int along = i == 0 ? v : u;
    const std::int32_t end = at.place[across] + (high ? 1 : 0);
    key = 2 * cells_.plane(across, end);
    if (end == 0 || end == 1 << cells_.halvings(across)) return;  // nothing is hit at the root's
    const int face_depth = cells_.depth_of_plane(at.axis, at.place[at.axis]);
    const int end_depth = cells_.depth_of_plane(across, end);
    LatticePoint within = at.place;  // a cell that the split is round
    EdgeId number = 0;
    if (face_depth > end_depth) {
      const SplitId split = tree_.split(cells_.code(within), face_depth);
      number = edge_of_split(split, edge_on_side(at.axis, across, high));
    } else {
      // Of coincident splits the lower one comes first: it ends the face below the line.
      if (high) --within[at.axis];
      const SplitId split = tree_.split(cells_.code(within), end_depth);
      number = edge_of_split(split, edge_on_side(across, at.axis, high));
      edge.owner = high ? EdgeOwner::kBelow : EdgeOwner::kAbove;
      edge.slot = high ? 1 : 2;
      if (!high) ++key;
    }
    edge.hits = grid_.edge_hits(number);
    const std::int32_t low = at.place[along];
    edge.hits.first = first_above(grid_.hits, edge.hits, cells_.plane(along, low));
    edge.hits.beyond = first_above(grid_.hits, edge.hits, cells_.plane(along, low + 1));
  }

  const FinestGrid& finest_;
  const FinestTree& tree_;
  const FinestCells& cells_;
  SolidMatcher matcher_;
  GridData& grid_;
  std::vector<HalfEdgeId> first_;  // per minimal face, three for each finest cell: the first
                                   // half-edge that came, kNone, or kCrowded
  std::vector<Face> crowded_;
  std::vector<OutlineHit> outline_;
  FaceMatch match_;
};

}  // namespace

void link_finest(const Surface& surface, std::span<const TriangleId> triangle_of_hit,
                 Pairing pairing, const FinestGrid& finest, GridData& grid) {
  FinestLinker(surface, triangle_of_hit, pairing, finest, grid).run();
}

}  // namespace kdm
