// SPDX-License-Identifier: MIT
// Visits every minimal face that carries hits (paper 3.3). A minimal face is the rectangle in which
// a side of one leaf meets a side of another.
//
// The two-dimensional trees of half-faces of paper 3.2 are the projections of the cell tree, so
// they are not stored: the recursion starts at each splitting face with the two children and goes
// down on both sides at once. A split along the face's own axis leads to the child that touches
// it; a split across the rectangle divides it, and the new side is the split's own splitting edge
// in the face's plane.
//
// Strips. If the cells on both sides of the face are split at the same value, the split on the
// lower side counts as lying infinitely little below the split on the upper side. Between the two
// lies a strip: a minimal face of no width between diagonal leaves, whose two long sides are the
// coincident edges. With strips, every hit has exactly three leaves and three minimal faces around
// it; uniform grids need no special case.
#pragma once

#include <algorithm>
#include <utility>

#include "grid/grid_data.h"

namespace kdm {

/// Which split a side of a minimal face comes from.
enum class EdgeOwner : std::uint8_t {
  kFace,   ///< the splitting face's own edge
  kBelow,  ///< a split on the lower side of the plane
  kAbove   ///< a split on the upper side
};

/// One side of a minimal face: a range of the hits on one splitting edge.
struct FaceEdge {
  HitRange hits;
  std::uint8_t slot = 0;  ///< of the hits' half-edges that cross this face
  EdgeOwner owner = EdgeOwner::kFace;
};

/// The rectangle that the sides of two leaves on either side of a splitting plane have in common.
struct MinimalFace {
  CellId below = 0;        ///< the leaf on the lower side of the plane
  CellId above = 0;        ///< the leaf on the upper side
  int axis = 0;            ///< normal to the face; u and v are the axes after it
  std::int32_t plane = 0;  ///< the coordinate along `axis`, lattice units
  /// The extent along u and v in half lattice units: twice the value of the split that bounds it,
  /// plus 1 if that split lies above the plane. So of coincident splits the lower one comes first.
  std::array<std::int32_t, 2> lo_key{};
  std::array<std::int32_t, 2> hi_key{};
  /// Numbered as splitting edges are: bottom (v low), right (u high), top (v high), left (u low).
  std::array<FaceEdge, 4> edges;

  std::int32_t lo(int i) const { return lo_key[i] >> 1; }
  std::int32_t hi(int i) const { return hi_key[i] >> 1; }
  bool strip() const { return lo(0) == hi(0) || lo(1) == hi(1); }
  Index hit_count() const {
    return edges[0].hits.size() + edges[1].hits.size() + edges[2].hits.size() +
           edges[3].hits.size();
  }
};

/// Returns whether links across the face had to be chosen, since more than one way to link its hits
/// may be right.
inline bool is_ambiguous(const MinimalFace& face) { return face.hit_count() > 2 && !face.strip(); }

/// Returns the two coincident sides of a strip, which carry the same hits.
inline std::pair<const FaceEdge&, const FaceEdge&> long_sides(const MinimalFace& strip) {
  const int first = strip.lo(0) == strip.hi(0) ? 1 : 0;
  return {strip.edges[first], strip.edges[first + 2]};
}

/// Calls `visit(vertex)` for the four corners of the face, which are grid vertices.
template <typename Visit>
void for_each_corner(const MinimalFace& face, const Visit& visit) {
  LatticePoint p;
  p[face.axis] = face.plane;
  for (const std::int32_t u : {face.lo(0), face.hi(0)}) {
    p[next_axis(face.axis)] = u;
    for (const std::int32_t v : {face.lo(1), face.hi(1)}) {
      p[previous_axis(face.axis)] = v;
      visit(p);
    }
  }
}

/// A hit on this edge has one half-edge that crosses the face. Returns whether this half-edge
/// starts in the leaf below the face; if not, it starts in the leaf above. `reversed` tells whether
/// the hit is reversed (see `Hit::reversed`).
constexpr bool starts_below(const FaceEdge& edge, bool reversed) {
  // !reversed: slot 0 V0->V1, slot 2 V1->VN, slot 1 VN->V0; reversed: the other way.
  if (edge.owner == EdgeOwner::kFace) return !reversed;
  const bool starts_in_child = edge.slot == 1 ? reversed : !reversed;
  return starts_in_child == (edge.owner == EdgeOwner::kBelow);
}

/// Calls `visit(edge, hit, side)` for every hit round the face, counter-clockwise: up along sides 0
/// and 1, down along sides 2 and 3. `edge` is the FaceEdge of that side.
template <typename Visit>
void for_each_hit(const MinimalFace& face, Visit&& visit) {
  for (int side = 0; side < 4; ++side) {
    const FaceEdge& edge = face.edges[side];
    for (Index i = 0; i < edge.hits.size(); ++i) {
      visit(edge, side < 2 ? edge.hits.first + i : edge.hits.beyond - 1 - i, side);
    }
  }
}

/// Finds the first hit of the range that lies above the lattice plane at `value`; `beyond` if none
/// does. Takes logarithmic time.
inline HitId first_above(const std::vector<Hit>& hits, HitRange range, std::int32_t value) {
  constexpr Index kShort = 8;  // hits that are looked at one by one sooner than by bisection
  if (range.size() <= kShort) {
    while (!range.empty() && floor_of(hits[range.first].position) < value) ++range.first;
    return range.first;
  }
  const auto first =
      std::partition_point(hits.begin() + range.first, hits.begin() + range.beyond,
                           [value](const Hit& hit) { return floor_of(hit.position) < value; });
  return static_cast<HitId>(first - hits.begin());
}

/// Goes down the trees of the cells on both sides of a splitting face and calls
/// `visit(const MinimalFace&)` for the minimal faces in it; use `for_each_face`.
template <typename Visit>
class FaceWalk {
 public:
  /// Visits faces without hits only if `empty_too`; stops for good after `most_steps` steps.
  FaceWalk(const GridData& grid, Visit& visit, std::uint64_t most_steps, bool empty_too)
      : grid_(grid), visit_(visit), steps_left_(most_steps), empty_too_(empty_too) {}

  bool exhausted() const { return steps_left_ == 0; }

  /// Visits the minimal faces in the splitting face of `cell`, which is no leaf and has this box.
  void visit_splitting_face(const Cell& cell, const LatticeBox& box) {
    MinimalFace face;
    face.axis = cell.axis();
    face.plane = cell.value();
    const int u = next_axis(face.axis);
    const int v = previous_axis(face.axis);
    face.lo_key = {2 * box.lo[u], 2 * box.lo[v]};
    face.hi_key = {2 * box.hi[u], 2 * box.hi[v]};
    for (int i = 0; i < 4; ++i) {
      face.edges[i] = {grid_.edge_hits(cell.split(), i), 0, EdgeOwner::kFace};
    }
    face.below = cell.below();
    face.above = cell.above();
    descend(face);
  }

 private:
  void descend(MinimalFace face) {
    const std::vector<Cell>& cells = grid_.cells;
    while (steps_left_ > 0) {
      --steps_left_;
      const Cell& below = cells[face.below];
      const Cell& above = cells[face.above];
      if (!empty_too_ && face.hit_count() == 0 && !below.active(face.axis, true) &&
          !above.active(face.axis, false)) {
        return;
      }
      const bool lower = !below.leaf();
      if (!lower && above.leaf()) {
        visit_(face);
        return;
      }
      const Cell& cell = lower ? below : above;
      CellId& side = lower ? face.below : face.above;
      if (cell.axis() == face.axis) {
        side = lower ? cell.above() : cell.below();
        continue;
      }
      const int i = cell.axis() == next_axis(face.axis) ? 0 : 1;
      const std::int32_t key = 2 * cell.value() + (lower ? 0 : 1);
      if (key <= face.lo_key[i]) {
        side = cell.above();
      } else if (key >= face.hi_key[i]) {
        side = cell.below();
      } else {
        MinimalFace first = face;
        divide(cell, lower, i, key, first, face);
        (lower ? first.below : first.above) = cell.below();
        side = cell.above();
        descend(first);
      }
    }
  }

  // Cuts the rectangle `second` at the split of `cell`, across direction i (0: u, 1: v). `first`, a
  // copy of it, becomes the part below the split. `lower` tells whether `cell` is on the lower side
  // of the face's plane.
  void divide(const Cell& cell, bool lower, int i, std::int32_t key, MinimalFace& first,
              MinimalFace& second) const {
    first.hi_key[i] = key;
    second.lo_key[i] = key;
    // Sides 0 and 2 run along u (direction 0), sides 1 and 3 along v.
    for (int side = i; side < 4; side += 2) {
      const HitId cut = first_above(grid_.hits, second.edges[side].hits, cell.value());
      first.edges[side].hits.beyond = cut;
      second.edges[side].hits.first = cut;
    }
    HitRange hits = grid_.edge_hits(cell.split(), edge_on_side(cell.axis(), first.axis, lower));
    const int other = 1 - i;
    if (!hits.empty()) {
      hits.first = first_above(grid_.hits, hits, first.lo(other));
      hits.beyond = first_above(grid_.hits, hits, first.hi(other));
    }
    const EdgeOwner owner = lower ? EdgeOwner::kBelow : EdgeOwner::kAbove;
    // The new side is the high end of `first` (it sees child V0) and the low end of `second`.
    const int high_side = i == 0 ? 1 : 2;
    const int low_side = i == 0 ? 3 : 0;
    first.edges[high_side] = {hits, 1, owner};
    second.edges[low_side] = {hits, 2, owner};
  }

  const GridData& grid_;
  Visit& visit_;
  std::uint64_t steps_left_;
  bool empty_too_;
};

/// Calls `visit(const MinimalFace&)` for every minimal face with a hit on one of its sides, cell by
/// cell. `boxes` come from `cell_boxes`. Takes `most_steps` steps down the trees at most, because
/// grids from files may be made to take endlessly many, and returns whether all faces were visited.
template <typename Visit>
bool for_each_face(const GridData& grid, const std::vector<LatticeBox>& boxes, Visit&& visit,
                   std::uint64_t most_steps = ~std::uint64_t{0}) {
  FaceWalk<std::remove_reference_t<Visit>> walk(grid, visit, most_steps, false);
  for (CellId c = 0; c < grid.cells.size() && !walk.exhausted(); ++c) {
    if (!grid.cells[c].leaf()) walk.visit_splitting_face(grid.cells[c], boxes[c]);
  }
  return !walk.exhausted();
}

/// Calls `visit(const MinimalFace&)` for every minimal face, with or without hits.
template <typename Visit>
void for_each_face_or_empty(const GridData& grid, const std::vector<LatticeBox>& boxes,
                            Visit&& visit) {
  FaceWalk<std::remove_reference_t<Visit>> walk(grid, visit, ~std::uint64_t{0}, true);
  for (CellId c = 0; c < grid.cells.size(); ++c) {
    if (!grid.cells[c].leaf()) walk.visit_splitting_face(grid.cells[c], boxes[c]);
  }
}

}  // namespace kdm
