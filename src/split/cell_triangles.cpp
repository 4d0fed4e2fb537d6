// SPDX-License-Identifier: MIT
#include "split/cell_triangles.h"

namespace kdm {

void CellTriangles::find(const LatticeBox& cell, std::span<const ListEntry> entries) {
  for (const TriangleId triangle : triangles_) member_of_[triangle] = kNone;
  cell_ = cell;
  triangles_.clear();
  bounds_.clear();
  outcodes_.clear();
  for (const ListEntry& entry : entries) {
    const LatticeTriangle& t = surface_.triangles[entry.triangle];
    const Outcodes codes = kdm::outcodes(t, cell);
    if (!triangle_meets_box(t, codes, cell)) continue;
    member_of_[entry.triangle] = size();
    triangles_.push_back(entry.triangle);
    bounds_.push_back({entry.lo, entry.hi});
    outcodes_.push_back(codes);
  }
}

}  // namespace kdm
