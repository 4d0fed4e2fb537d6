// SPDX-License-Identifier: MIT
// Makes the lists of enclosed triangles when they are asked for.
#include "extract/embed/leaf_triangles.h"

namespace kdm {

std::span<const TriangleId> LeafTriangles::enclosed(CellId leaf, const Suspects& suspects) {
  Index& begin = enclosed_begin_[leaf];
  if (begin == kNone) {
    begin = static_cast<Index>(enclosed_lists_.size());
    enclosed_lists_.push_back(0);
    suspects.for_each_enclosed_triangle(leaf, [&](TriangleId t) { enclosed_lists_.push_back(t); });
    enclosed_lists_[begin] = static_cast<Index>(enclosed_lists_.size()) - begin - 1;
  }
  return {enclosed_lists_.data() + begin + 1, enclosed_lists_[begin]};
}

}  // namespace kdm
