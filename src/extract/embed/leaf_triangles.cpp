// SPDX-License-Identifier: MIT
// Makes the lists of enclosed triangles of leaves whose lists are to be read.
#include "extract/embed/leaf_triangles.h"

namespace kdm {

void LeafTriangles::prepare(CellId leaf, const Suspects& suspects) {
  Index& begin = enclosed_begin_[leaf];
  if (begin != kNone) return;
  begin = static_cast<Index>(enclosed_lists_.size());
  enclosed_lists_.push_back(0);
  suspects.for_each_enclosed_triangle(leaf, [&](TriangleId t) { enclosed_lists_.push_back(t); });
  enclosed_lists_[begin] = static_cast<Index>(enclosed_lists_.size()) - begin - 1;
  for (Index* at = &first_note_[leaf]; *at != kNone;) {
    Note& note = notes_[*at];
    if (note.triangle == kNone) {
      *at = note.next;
    } else {
      at = &note.next;
    }
  }
}

}  // namespace kdm
