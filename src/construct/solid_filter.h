// SPDX-License-Identifier: MIT
// Of several solids, leaves out of each cell those whose faces bound nothing in it: what lies
// within another part of a union, for instance. So cells are split where the result ends and
// nowhere else.
#pragma once

#include <vector>

#include "construct/former_cells.h"
#include "inside/inside_model.h"
#include "split/triangle_lists.h"

namespace kdm {

/// Looks at the list of one cell after the other.
class SolidFilter {
 public:
  /// Keeps references to both.
  SolidFilter(const Surface& surface, InsideModel& model)
      : surface_(surface), model_(model), wanted_(surface.operand_of_solid.size()) {}

  /// Returns whether there are several solids at all.
  bool exist() const { return surface_.several_solids(); }

  /// Returns the solids that have triangles in a list. There must be no more than there are bits.
  SolidBits bits_of(std::span<const ListEntry> entries) const {
    SolidBits bits = 0;
    for (const ListEntry& entry : entries)
      bits |= SolidBits{1} << surface_.solid_of[entry.triangle];
    return bits;
  }

  /// Drops from the list of a cell the triangles of solids that make no difference there, as
  /// follows from the solids that are in the list and from the state at one of the cell's corners.
  /// Returns whether triangles of several solids are left; if not, the lists of the cell's parts
  /// need not be looked at. Takes time linear in the list.
  bool leave_out(int state, TriangleLists& lists, ListRange& list) {
    present_.clear();
    wanted_.clear_all();
    for (const ListEntry& entry : lists.entries(list)) {
      const Index solid = surface_.solid_of[entry.triangle];
      if (!wanted_.test_and_set(solid)) present_.push_back(solid);
    }
    model_.keep_relevant(state, wanted_);
    std::size_t left = 0;
    for (const Index solid : present_) left += wanted_.test(solid) ? 1 : 0;
    if (left < present_.size()) {
      list = lists.keep_if(list, [&](TriangleId t) { return wanted_.test(surface_.solid_of[t]); });
    }
    return left > 1;
  }

 private:
  const Surface& surface_;
  InsideModel& model_;
  Marks wanted_;                // per solid
  std::vector<Index> present_;  // solids in the list
};

}  // namespace kdm
