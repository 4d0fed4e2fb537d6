// SPDX-License-Identifier: MIT
// Which triangles reach which cell: one arena of entries, used as a stack (paper 5.1.1 hands
// clipped polygons down; we hand down numbers and the bounds of the clipped part).
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "geometry/lattice.h"
#include "geometry/plane.h"

namespace kdm {

/// A triangle's part in a cell: bounds that hold the part, rounded outwards. Left uninitialised by
/// default, since the arena makes many at once.
struct ListEntry {
  Index triangle;
  LatticePoint lo;
  LatticePoint hi;
};

/// Entries of a cell: [begin, end) of the arena.
struct ListRange {
  Index begin = 0;
  Index end = 0;
  Index size() const { return end - begin; }
};

class TriangleLists {
 public:
  /// Starts with all triangles; those without area too, since they join their neighbours.
  explicit TriangleLists(const std::vector<LatticeTriangle>& triangles);

  ListRange all() const { return {0, all_}; }
  std::span<const ListEntry> entries(ListRange range) const {
    return {arena_.get() + range.begin, range.size()};
  }

  const ListEntry& entry(Index i) const { return arena_[i]; }

  /// Appends the lists of both children. Give them back with `release(below)`, after all that came
  /// later.
  struct Children {
    ListRange below;
    ListRange above;
  };
  Children divide(ListRange parent, int axis, std::int32_t value);
  void release(ListRange below) { size_ = below.begin; }

  /// Numbers of arena entries of the last divided cell that reach both sides of the plane: the
  /// only ones that can meet the splitting face. Valid until the next `divide`.
  std::span<const Index> straddlers() const { return straddlers_; }

 private:
  void make_room(std::size_t entries);
  void divide_straddler(const ListEntry& entry, int axis, std::int32_t value);

  const std::vector<LatticeTriangle>& triangles_;
  std::unique_ptr<ListEntry[]> arena_;
  std::size_t capacity_ = 0;
  Index size_ = 0;
  std::vector<ListEntry> above_;  // of the cell being divided
  std::vector<Index> straddlers_;
  Index all_ = 0;
};

}  // namespace kdm
