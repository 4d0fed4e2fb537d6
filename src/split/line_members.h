// SPDX-License-Identifier: MIT
// Which of a cell's triangles may lie on a way along grid lines.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "split/cell_triangles.h"

namespace kdm {

/// Lists a cell's members by where they lie, for ways that lead from the cell's lowest corner to
/// points in it along axis 0, then along axis 1, then along axis 2. One object serves cell after
/// cell.
class LineMembers {
 public:
  /// Lists the members of a cell, in time linear in their number but for wide ones.
  void list(const CellTriangles& cell);

  /// Calls `visit(member)` for all members that may meet the part of the way along `axis`, on the
  /// grid line through `point`; ascending.
  template <typename Visit>
  void for_each(int axis, const LatticePoint& point, const Visit& visit) const {
    if (axis == 0) {
      for (const MemberId m : on_first_edge_) visit(m);
    } else if (axis == 1) {
      for (const MemberId m : in_strips_.of(column_of(point[0], 0))) visit(m);
    } else {
      const std::size_t column = column_of(point[0], 0) * columns_ + column_of(point[1], 1);
      for (const MemberId m : in_columns_.of(column)) visit(m);
    }
  }

 private:
  // The members at each of some places, ascending.
  struct Lists {
    std::vector<Index> first;  // per place where its members begin in `all`; last, their number
    std::vector<MemberId> all;

    std::span<const MemberId> of(std::size_t place) const {
      return {all.data() + first[place], first[place + 1] - first[place]};
    }
    template <typename ForEachPlace>
    void fill(std::size_t places, Index members, const ForEachPlace& for_each_place);
  };

  // Bounds of members are rounded outwards, so positions may lie beside the cell.
  std::size_t column_of(std::int32_t position, int axis) const {
    const std::int64_t width = std::int64_t{box_.hi[axis]} - box_.lo[axis];
    const std::int64_t within = std::clamp(position, box_.lo[axis], box_.hi[axis]) - box_.lo[axis];
    return static_cast<std::size_t>(within * static_cast<std::int64_t>(columns_) / (width + 1));
  }
  template <typename Visit>
  void for_each_strip(const LatticeBox& bounds, const Visit& visit) const;
  template <typename Visit>
  void for_each_column(const LatticeBox& bounds, const Visit& visit) const;

  LatticeBox box_;                       // of the cell
  std::vector<MemberId> on_first_edge_;  // at the cell's lowest edge along axis 0
  // The cell is cut into columns along axis 2: so many along axis 0 and along axis 1. Those along
  // axis 0 cut its lowest side across axis 2 into strips.
  std::size_t columns_ = 1;
  Lists in_strips_;
  Lists in_columns_;
};

}  // namespace kdm
