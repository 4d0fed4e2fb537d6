// SPDX-License-Identifier: MIT
#include "merge/corner_signs.h"

#include <array>

#include "construct/cell_border.h"
#include "grid/faces.h"
#include "split/split_rules.h"

namespace kdm {
namespace {

// What a cell hands down: the hits on its edges, numbered as `cell_edge` does, and its corners.
struct SignedCell {
  CellId cell = 0;
  std::array<HitRange, 12> edges{};
  std::uint8_t corners = 0;
};

void set_corner(SignedCell& cell, int corner, bool inside) {
  const auto bit = static_cast<std::uint8_t>(1 << corner);
  cell.corners = static_cast<std::uint8_t>(inside ? cell.corners | bit : cell.corners & ~bit);
}

// Cuts the four edges along the axis of a split, and finds the corners of the splitting face.
void cut_edges_at(const GridData& grid, const Cell& split, SignedCell& below, SignedCell& above) {
  const int w = split.axis();
  for (int e = 0; e < 4; ++e) {
    HitRange& lower = below.edges[4 * w + e];
    HitRange& upper = above.edges[4 * w + e];
    lower.beyond = upper.first = first_above(grid.hits, lower, split.value());
    const int low_corner =
        ((e & 1) != 0 ? 1 << next_axis(w) : 0) | ((e & 2) != 0 ? 1 << previous_axis(w) : 0);
    const bool inside = ((below.corners >> low_corner & 1) != 0) != (lower.size() % 2 != 0);
    set_corner(below, low_corner | 1 << w, inside);
    set_corner(above, low_corner, inside);
  }
}

}  // namespace

std::vector<std::uint8_t> corner_signs(const GridData& grid) {
  std::vector<std::uint8_t> signs(grid.cells.size(), 0);
  std::vector<SignedCell> open{SignedCell()};
  while (!open.empty()) {
    const SignedCell cell = open.back();
    open.pop_back();
    signs[cell.cell] = cell.corners;
    const Cell& split = grid.cells[cell.cell];
    if (split.leaf()) continue;
    SignedCell below = cell;
    SignedCell above = cell;
    below.cell = split.below();
    above.cell = split.above();
    cut_edges_at(grid, split, below, above);
    for (int i = 0; i < 4; ++i) {
      hand_down_edge(split.axis(), i, grid.edge_hits(split.split(), i), below.edges, above.edges);
    }
    open.push_back(above);
    open.push_back(below);
  }
  return signs;
}

}  // namespace kdm
