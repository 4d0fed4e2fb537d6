// SPDX-License-Identifier: MIT
// Follows a line along an axis through the cells of a grid.
#pragma once

#include <algorithm>

#include "grid/grid_data.h"

namespace kdm {

/// A stretch of a line: on one splitting edge, or within one leaf. Only the ends of a leaf's sides
/// are not within the leaf: like every grid point, the line counts as shifted by (e, e^2, e^3), so
/// that one in the plane between two leaves runs in the upper one.
struct LineStretch {
  std::int32_t low;  ///< coordinates along the line's axis
  std::int32_t high;
  EdgeId edge = kNone;  ///< the splitting edge; kNone: within a leaf
  CellId leaf = kNone;  ///< of a stretch within a leaf

  bool on_edge() const { return edge != kNone; }
};

/// Visits the stretches of lines along an axis; see `for_each_stretch`.
template <typename Visit>
class GridLine {
 public:
  GridLine(const GridData& grid, const std::vector<LatticeBox>& boxes, int axis,
           const LatticePoint& on_line, Visit& visit)
      : grid_(grid), boxes_(boxes), axis_(axis), on_line_(on_line), visit_(visit) {}

  /// Visits what lies in a cell.
  void follow(CellId cell, std::int32_t low, std::int32_t high) {
    while (!grid_.cells[cell].leaf()) {
      const Cell& split = grid_.cells[cell];
      if (split.axis() == axis_) {
        if (low < split.value() && split.value() < high) {
          follow(split.below(), low, split.value());
          low = split.value();
        }
        cell = high <= split.value() ? split.below() : split.above();
        continue;
      }
      const std::int32_t at = on_line_[split.axis()];
      if (at == split.value()) return follow_plane(cell, low, high);
      cell = at < split.value() ? split.below() : split.above();
    }
    visit_(LineStretch{low, high, kNone, cell});
  }

 private:
  // Visits what lies in the splitting face of a cell.
  void follow_plane(CellId cell, std::int32_t low, std::int32_t high) {
    const Cell& split = grid_.cells[cell];
    const int across = 3 - axis_ - split.axis();
    const std::int32_t at = on_line_[across];
    const LatticeBox& box = boxes_[cell];
    if (at == box.lo[across] || at == box.hi[across]) {
      const int i = edge_on_side(split.axis(), across, at == box.hi[across]);
      visit_(LineStretch{low, high, edge_of_split(split.split(), i)});
    } else {
      follow_between(split.below(), split.above(), split.axis(), low, high);
    }
  }

  // Visits what lies between two cells on either side of a plane of `normal`, in no splitting edge
  // of their ancestors.
  void follow_between(CellId below, CellId above, int normal, std::int32_t low, std::int32_t high) {
    const int across = 3 - axis_ - normal;
    while (!grid_.cells[below].leaf() || !grid_.cells[above].leaf()) {
      const bool lower = !grid_.cells[below].leaf();
      CellId& side = lower ? below : above;
      const Cell& split = grid_.cells[side];
      if (split.axis() == normal) {
        side = lower ? split.above() : split.below();
      } else if (split.axis() == axis_) {
        if (low < split.value() && split.value() < high) {
          const CellId first = split.below();
          follow_between(lower ? first : below, lower ? above : first, normal, low, split.value());
          low = split.value();
        }
        side = high <= split.value() ? split.below() : split.above();
      } else if (on_line_[across] == split.value()) {
        const int i = edge_on_side(across, normal, lower);
        visit_(LineStretch{low, high, edge_of_split(split.split(), i)});
        return;
      } else {
        side = on_line_[across] < split.value() ? split.below() : split.above();
      }
    }
    visit_(LineStretch{low, high, kNone, above});
  }

  const GridData& grid_;
  const std::vector<LatticeBox>& boxes_;
  int axis_;
  const LatticePoint& on_line_;
  Visit& visit_;
};

/// Calls `visit(const LineStretch&)` for the stretches of the line along `axis` through `on_line`
/// between two coordinates, ascending. A line of no length has one stretch: what ends there.
/// `boxes` come from `cell_boxes`.
template <typename Visit>
void for_each_stretch(const GridData& grid, const std::vector<LatticeBox>& boxes, int axis,
                      const LatticePoint& on_line, std::int32_t low, std::int32_t high,
                      Visit&& visit) {
  GridLine<std::remove_reference_t<Visit>>(grid, boxes, axis, on_line, visit).follow(0, low, high);
}

/// Returns the cell furthest down the tree that holds a box.
inline CellId cell_around(const GridData& grid, const LatticeBox& box) {
  CellId cell = 0;
  while (!grid.cells[cell].leaf()) {
    const Cell& split = grid.cells[cell];
    if (box.hi[split.axis()] <= split.value()) {
      cell = split.below();
    } else if (box.lo[split.axis()] >= split.value()) {
      cell = split.above();
    } else {
      break;
    }
  }
  return cell;
}

}  // namespace kdm
