// SPDX-License-Identifier: MIT
// Lists the triangles that may lie in a leaf: the suspects (see suspects.h), and the triangles of
// enclosed hits.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "extract/embed/suspects.h"

namespace kdm {

/// Lists, for each leaf, the suspects that were noted in it, and the triangles of enclosed hits.
class LeafTriangles {
 public:
  /// Makes empty lists for this number of cells.
  explicit LeafTriangles(Index cells) : enclosed_begin_(cells, kNone), first_note_(cells, kNone) {}

  /// Makes ready for a mesh that has `triangles` triangles now: gives the suspects the numbers
  /// `now(t)` and forgets those for which that is kNone, and all lists of enclosed triangles.
  template <typename Now>
  void renumber(Index triangles, const Now& now);

  /// Notes that the triangle may lie in the leaf. Counts once it is marked as a suspect.
  void note(CellId leaf, TriangleId t) {
    notes_.push_back({t, first_note_[leaf]});
    first_note_[leaf] = static_cast<Index>(notes_.size() - 1);
  }
  /// Marks the triangle as a suspect, after it was noted in all leaves in which it may lie.
  void mark_suspect(TriangleId t) { is_suspect_.set(t); }
  /// Tells whether any triangle was ever noted.
  bool any_noted() const { return !notes_.empty(); }

  /// Calls `visit(t)` for each suspect that was noted in the leaf, the last one first.
  template <typename Visit>
  void for_each_suspect(CellId leaf, const Visit& visit);

  /// Lists the triangles of enclosed hits that may lie in the leaf, some of them twice. Makes the
  /// list when it is first asked for after an update. Valid until the next call.
  std::span<const TriangleId> enclosed(CellId leaf, const Suspects& suspects);

 private:
  struct Note {
    TriangleId triangle;
    Index next;
  };

  Marks is_suspect_;  // per triangle
  // The lists of enclosed triangles, one behind another: their number, then the triangles.
  std::vector<Index> enclosed_lists_;
  std::vector<Index> enclosed_begin_;  // per cell: where its list is; kNone: not made yet
  // Linked lists of notes. A note is void if its triangle is kNone or no suspect (any more); it is
  // taken out when it is met.
  std::vector<Note> notes_;
  std::vector<Index> first_note_;  // per cell
};

template <typename Now>
void LeafTriangles::renumber(Index triangles, const Now& now) {
  Marks is_suspect(triangles);
  for (Note& note : notes_) {
    if (note.triangle == kNone) continue;
    note.triangle = is_suspect_.test(note.triangle) ? now(note.triangle) : kNone;
    if (note.triangle != kNone) is_suspect.set(note.triangle);
  }
  is_suspect_ = std::move(is_suspect);
  enclosed_lists_.clear();
  enclosed_begin_.assign(enclosed_begin_.size(), kNone);
}

template <typename Visit>
void LeafTriangles::for_each_suspect(CellId leaf, const Visit& visit) {
  for (Index* at = &first_note_[leaf]; *at != kNone;) {
    Note& note = notes_[*at];
    if (note.triangle == kNone || !is_suspect_.test(note.triangle)) {
      *at = note.next;
      continue;
    }
    visit(note.triangle);
    at = &note.next;
  }
}

}  // namespace kdm
