// SPDX-License-Identifier: MIT
// What a cell knows of its border: the crossings on its twelve edges and the states at its corners.
#pragma once

#include <array>
#include <vector>

#include "grid/grid_data.h"
#include "inside/crossing.h"
#include "split/split_rules.h"

namespace kdm {

/// The border of a cell. Corners are numbered by bits: 1 for x, 2 for y, 4 for z at the high end.
struct CellBorder {
  CellEdges edges;
  std::array<int, 8> state{};  ///< of the inside model at the corners
};

/// Cuts the four edges that run across the plane of a split. The crossings on them lead from the
/// states at the cell's corners to those at the corners of the splitting face:
/// `state_at(high_next, high_previous, counted)` makes of the counted state that of the corner at
/// these ends of the axes after the split's. Both halves must be copies of the cell's border.
template <typename StateAt>
void cut_edges(const Split& split, const std::vector<ClassifiedCrossing>& crossings,
               const StateAt& state_at, CellBorder& below, CellBorder& above) {
  const int w = split.axis;
  for (int e = 0; e < 4; ++e) {
    const bool high_next = (e & 1) != 0;
    const bool high_previous = (e & 2) != 0;
    const EdgeRange whole = below.edges[4 * w + e];
    Index cut = whole.begin;
    while (cut < whole.end && floor_of(crossings[cut].position()) < split.value) ++cut;
    below.edges[4 * w + e].end = cut;
    above.edges[4 * w + e].begin = cut;
    const int low_corner =
        (high_next ? 1 << next_axis(w) : 0) | (high_previous ? 1 << previous_axis(w) : 0);
    const int high_corner = low_corner | 1 << w;
    const int counted =
        cut == whole.begin ? below.state[low_corner] : crossings[cut - 1].state_after();
    const int state = state_at(high_next, high_previous, counted);
    below.state[high_corner] = state;
    above.state[low_corner] = state;
  }
}

/// Hands splitting edge `i` of a split along `axis`, of whose crossings or hits there is a range,
/// to the edges of both halves.
template <typename Range>
void hand_down_edge(int axis, int i, const Range& range, std::array<Range, 12>& below,
                    std::array<Range, 12>& above) {
  const int u = next_axis(axis);
  const int v = previous_axis(axis);
  // Edges 0 and 2 run along u, at the low and high end of v; 1 and 3 along v, at the high and low
  // end of u. For axis u the next axis is v and the previous one is `axis`.
  const bool high = i == 1 || i == 2;
  if (axis_of_edge(axis, i) == u) {
    below[cell_edge(u, high, true)] = range;
    above[cell_edge(u, high, false)] = range;
  } else {
    below[cell_edge(v, true, high)] = range;
    above[cell_edge(v, false, high)] = range;
  }
}

}  // namespace kdm
