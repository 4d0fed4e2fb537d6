// SPDX-License-Identifier: MIT
// Climbs from a leaf to a cell round a box.
#include "extract/embed/leaf_tree.h"

namespace kdm {

LeafTree::LeafTree(const GridView& view) : view_(view), parent_(view.grid.cells.size(), kNone) {
  for (CellId c = 0; c < view.grid.cells.size(); ++c) {
    const Cell& cell = view.grid.cells[c];
    if (!cell.leaf()) parent_[cell.below()] = parent_[cell.above()] = c;
  }
}

// Returns the smallest cell round the leaf that has the whole box inside of it, or the root.
CellId LeafTree::smallest_cell_round(const Vec3& lo, const Vec3& hi, CellId near) const {
  CellId cell = near;
  while (cell != 0 && !((lo.array() > to_vec3(view_.boxes[cell].lo).array()).all() &&
                        (hi.array() < to_vec3(view_.boxes[cell].hi).array()).all())) {
    cell = parent_[cell];
  }
  return cell;
}

}  // namespace kdm
