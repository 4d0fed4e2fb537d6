// SPDX-License-Identifier: MIT
#include "merge/merge_model.h"

#include <algorithm>

#include "grid/splitting_edges.h"
#include "inside/write_hits.h"
#include "merge/grid_vertices.h"

namespace kdm {
namespace {

// So near to each other, in lattice units, rounding may have put a point of the spanned surface on
// the other side of a grid vertex than its hit.
constexpr std::int32_t kRounding = 2;

// Leaves one of an odd number of crossings at one position, and none of an even one.
void drop_pairs(std::vector<SolidCrossing>& found) {
  std::size_t kept = 0;
  for (const SolidCrossing& crossing : found) {
    if (kept > 0 && found[kept - 1].position == crossing.position) {
      --kept;
    } else {
      found[kept++] = crossing;
    }
  }
  found.resize(kept);
}

}  // namespace

int MergeModel::state_at(const LatticePoint& vertex, int counted) {
  static_cast<void>(counted);
  return (solids_[0]->inside(vertex) ? 1 : 0) + (solids_[1]->inside(vertex) ? 2 : 0);
}

int MergeModel::state_after(int state, TriangleId triangle, bool leaving) {
  const int bit = 1 << surface_.solid_of[triangle];
  return leaving ? state & ~bit : state | bit;
}

void MergeModel::keep_relevant(int state, Marks& solids) {
  const int open = (solids.test(0) ? 1 : 0) + (solids.test(1) ? 2 : 0);
  for (int i = 0; i < 2; ++i) {
    // A solid makes a difference if it does for some state of the other one, if that is open too.
    const int other = open & ~(1 << i);
    if (!function_.depends_on(1 << i, state & ~other) &&
        !function_.depends_on(1 << i, state | other)) {
      solids.clear(i);
    }
  }
}

void MergeModel::plan_edge(const GridEdge& edge, std::vector<Crossing>& found,
                           std::vector<ClassifiedCrossing>& planned) {
  static_cast<void>(found);
  plan_stretch(edge.axis, edge.low, edge.high, edge.state_low, edge.state_high, planned);
}

void MergeModel::finish_edges(const EdgeCrossings& planned, HitWriter& writer) {
  static_cast<void>(planned);
  const GridData& grid = writer.grid();
  const std::vector<LatticeBox> boxes = cell_boxes(grid);
  const GridVertices vertices(grid, boxes, [&](const LatticePoint& p) { return state_at(p, 0); });
  EdgeCrossings fitted;
  for_each_splitting_edge(grid, boxes, [&](const SplittingEdge& edge) {
    LatticePoint low = edge.low();
    const auto on_edge = vertices.between(edge.axis, low, edge.box.hi[edge.axis]);
    for (std::size_t i = 0; i + 1 < on_edge.size(); ++i) {
      low[edge.axis] = on_edge[i].along();
      plan_stretch(edge.axis, low, on_edge[i + 1].along(), on_edge[i].state, on_edge[i + 1].state,
                   fitted.all);
    }
    fitted.edge_begin.push_back(static_cast<Index>(fitted.all.size()));
  });
  write_hits(fitted, writer);
}

// Plans the crossings between two points of an edge, as the states of these two demand.
void MergeModel::plan_stretch(int axis, const LatticePoint& low, std::int32_t high, int state_low,
                              int state_high, std::vector<ClassifiedCrossing>& planned) {
  for (int i = 0; i < 2; ++i) {
    found_[i].clear();
    solids_[i]->find_crossings(axis, low, low[axis], high, found_[i]);
    drop_pairs(found_[i]);
    fit(i, axis, low, high, (state_low >> i & 1) != 0, (state_high >> i & 1) != 0);
  }
  const std::size_t before = planned.size();
  int state = state_low;
  const auto of_second = static_cast<TriangleId>(solids_[0]->surface().corners.size());
  auto first = found_[0].begin();
  auto second = found_[1].begin();
  while (first != found_[0].end() || second != found_[1].end()) {
    const bool take_first = second == found_[1].end() ||
                            (first != found_[0].end() && first->position <= second->position);
    const bool take_second = first == found_[0].end() ||
                             (second != found_[1].end() && second->position <= first->position);
    const int after = state ^ (take_first ? 1 : 0) ^ (take_second ? 2 : 0);
    const bool was_inside = function_.inside(state);
    const bool bounds = was_inside != function_.inside(after);
    const auto add = [&](const SolidCrossing& crossing, TriangleId base, bool kept) {
      planned.emplace_back(crossing.position, base + crossing.triangle, after,
                           kept ? CrossingRole::kBounds : CrossingRole::kInner, was_inside);
    };
    if (take_first) add(*first, 0, bounds);
    if (take_second) add(*second, of_second, bounds && !take_first);
    if (take_first) ++first;
    if (take_second) ++second;
    state = after;
  }
  // What one solid has by itself stays as it is.
  if (!found_[0].empty() && !found_[1].empty()) {
    gaps_.close(axis, std::span(planned).subspan(before));
  }
}

// Makes the crossings of a solid lead from the one sign to the other.
void MergeModel::fit(int solid, int axis, const LatticePoint& low, std::int32_t high,
                     bool inside_low, bool inside_high) {
  std::vector<SolidCrossing>& found = found_[solid];
  if ((found.size() % 2 != 0) == (inside_low != inside_high)) return;
  ++fitted_;
  if (!found.empty()) {
    const std::int32_t from_low = floor_of(found.front().position) - low[axis];
    const std::int32_t from_high = high - floor_of(found.back().position);
    if (from_low <= kRounding && from_low <= from_high) {
      found.erase(found.begin());
      return;
    }
    if (from_high <= kRounding) {
      found.pop_back();
      return;
    }
  }
  add_missing(solid, axis, low, high);
}

// Adds a crossing beside the end at which rounding has moved the surface over the grid vertex.
void MergeModel::add_missing(int solid, int axis, const LatticePoint& low, std::int32_t high) {
  const GridSolid& of = *solids_[solid];
  LatticePoint end = low;
  end[axis] = high;
  std::vector<SolidCrossing>& found = found_[solid];
  LinePosition position = static_cast<LinePosition>(low[axis]) << kFractionBits;
  HitId hit = of.hit_beside(low, kRounding);
  if (hit == kNone) {
    hit = of.hit_beside(end, kRounding);
    if (hit != kNone) position = (static_cast<LinePosition>(high) << kFractionBits) - 1;
  }
  const Index triangle = hit == kNone ? kNone : of.triangle_of(hit);
  const auto after = std::find_if(found.begin(), found.end(), [&](const SolidCrossing& crossing) {
    return crossing.position >= position;
  });
  if (after != found.end() && after->position == position) {
    found.erase(after);
  } else {
    found.insert(after, {position, triangle == kNone ? 0 : triangle, false});
  }
}

}  // namespace kdm
