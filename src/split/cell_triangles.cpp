// SPDX-License-Identifier: MIT
#include "split/cell_triangles.h"

#include "geometry/triangle_box.h"

namespace kdm {

void CellTriangles::find(const LatticeBox& cell, std::span<const ListEntry> entries) {
  for (const TriangleId triangle : triangles_) member_of_[triangle] = kNone;
  cell_ = cell;
  triangles_.clear();
  bounds_.clear();
  for (const ListEntry& entry : entries) {
    if (!triangle_meets_box(surface_.triangles[entry.triangle], cell)) continue;
    member_of_[entry.triangle] = size();
    triangles_.push_back(entry.triangle);
    bounds_.push_back({entry.lo, entry.hi});
  }
}

}  // namespace kdm
