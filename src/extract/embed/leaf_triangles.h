// SPDX-License-Identifier: MIT
// Lists the triangles that may lie in a leaf: the suspects (see suspects.h), and the triangles of
// enclosed hits.
#pragma once

#include <span>
#include <vector>

#include "extract/embed/suspects.h"

namespace kdm {

/// Lists, for each leaf, the suspects that were noted in it, and the triangles of enclosed hits.
class LeafTriangles {
 public:
  /// Makes empty lists for this number of cells.
  explicit LeafTriangles(Index cells) : enclosed_begin_(cells, kNone), first_note_(cells, kNone) {}

  /// Makes ready for a mesh that has changed: gives the suspects the numbers `now(t)` and forgets
  /// those for which that is kNone, and all lists of enclosed triangles.
  template <typename Now>
  void renumber(const Now& now);

  /// Notes that the triangle, a suspect, may lie in the leaf.
  void note(CellId leaf, TriangleId t) {
    notes_.push_back({t, first_note_[leaf]});
    first_note_[leaf] = static_cast<Index>(notes_.size() - 1);
  }
  /// Tells whether any triangle was ever noted.
  bool any_noted() const { return !notes_.empty(); }

  /// Takes out what is void of the leaf's list of suspects, and makes the leaf's list of enclosed
  /// triangles if it was not made since `renumber`. To be done before the leaf's lists are read.
  void prepare(CellId leaf, const Suspects& suspects);
  /// Calls `visit(t)` for each suspect that was noted in the leaf, the last one first.
  template <typename Visit>
  void for_each_suspect(CellId leaf, const Visit& visit) const {
    for (Index at = first_note_[leaf]; at != kNone; at = notes_[at].next) {
      visit(notes_[at].triangle);
    }
  }
  /// Lists the triangles of enclosed hits that may lie in the leaf, some of them twice. Valid until
  /// the next `prepare`.
  std::span<const TriangleId> enclosed(CellId leaf) const {
    const Index begin = enclosed_begin_[leaf];
    return {enclosed_lists_.data() + begin + 1, enclosed_lists_[begin]};
  }

 private:
  struct Note {
    TriangleId triangle;
    Index next;
  };

  // The lists of enclosed triangles, one behind another: their number, then the triangles.
  std::vector<Index> enclosed_lists_;
  std::vector<Index> enclosed_begin_;  // per cell: where its list is; kNone: not made yet
  // Linked lists of notes. A note is void if its triangle is kNone, as that of a triangle that is
  // no suspect any more.
  std::vector<Note> notes_;
  std::vector<Index> first_note_;  // per cell
};

template <typename Now>
void LeafTriangles::renumber(const Now& now) {
  for (Note& note : notes_) {
    if (note.triangle != kNone) note.triangle = now(note.triangle);
  }
  enclosed_lists_.clear();
  enclosed_begin_.assign(enclosed_begin_.size(), kNone);
}

}  // namespace kdm
