// SPDX-License-Identifier: MIT
// Lists of the triangles that reach each cell. Construction hands them down the tree: when a cell
// is split, its list is divided into those of its children. Paper 5.1.1 hands down polygons clipped
// to the cell; we hand down the triangle's number and bounds of the clipped polygon.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "geometry/lattice.h"
#include "geometry/plane.h"
#include "mesh/numbers.h"

namespace kdm {

/// A triangle that may reach a cell, with bounds of its part in the cell. The fields have no
/// initial values, because the arena makes many entries at once.
struct ListEntry {
  TriangleId triangle;
  LatticePoint lo;  ///< the least corner of the bounds, in lattice units, rounded outwards
  LatticePoint hi;  ///< the greatest corner
};

/// Returns the entry of a whole triangle.
ListEntry whole_entry(TriangleId triangle, const LatticeTriangle& t);

/// The parts of an entry below and above a plane.
struct DividedEntry {
  std::array<ListEntry, 2> part;
  /// Whether there may be such a part; one that is not there is not set.
  std::array<bool, 2> meets;
};

/// Divides the entry of a triangle that reaches both sides of lattice plane `value` across `axis`.
DividedEntry divide_entry(const LatticeTriangle& t, const ListEntry& entry, int axis,
                          std::int32_t value);

/// The entries of one cell: the numbers from `begin` up to, but not including, `end`.
struct ListRange {
  Index begin = 0;
  Index end = 0;
  Index size() const { return end - begin; }
};

/// Keeps the lists of the cells from the root to the cell at hand, and of their siblings, in one
/// array that grows and shrinks like a stack. A list holds every triangle that meets its cell, and
/// maybe a few that only come near it.
class TriangleLists {
 public:
  /// Makes the list of the root cell, which holds all triangles. Triangles without area are among
  /// them, because their neighbours are connected through them. Keeps a reference to `triangles`.
  explicit TriangleLists(const std::vector<LatticeTriangle>& triangles);
  /// Makes the list of a cell from these entries; it stands for that of the root cell.
  TriangleLists(const std::vector<LatticeTriangle>& triangles, std::span<const ListEntry> entries);

  /// Returns the list of the root cell.
  ListRange all() const { return {0, root_size_}; }
  /// Returns the entries of a list. They may move at the next `divide`.
  std::span<const ListEntry> entries(ListRange range) const {
    return {arena_.get() + range.begin, range.size()};
  }

  const ListEntry& entry(Index number) const { return arena_[number]; }

  /// The lists of the two children of a split cell.
  struct Children {
    ListRange below;
    ListRange above;
  };
  /// Makes the lists of the children of a cell that is split at lattice plane `value` across
  /// `axis`. The parent's list stays as it is. Takes time linear in the length of the parent's
  /// list.
  Children divide(ListRange parent, int axis, std::int32_t value);
  /// Keeps those entries of a list whose triangles `keep` asks for, and returns the shorter list.
  template <typename Keep>
  ListRange keep_if(ListRange range, const Keep& keep) {
    Index end = range.begin;
    for (Index i = range.begin; i < range.end; ++i) {
      if (keep(arena_[i].triangle)) arena_[end++] = arena_[i];
    }
    return {range.begin, end};
  }
  /// Removes the lists of two children, and all lists that were made after them. `below` is the
  /// list of the lower child.
  void release(ListRange below) { size_ = below.begin; }

  /// Returns the numbers of the entries, of the cell that was divided last, whose triangles reach
  /// both sides of the splitting plane. No other triangles can meet the splitting face. The numbers
  /// are valid until the next `divide`.
  std::span<const Index> straddlers() const { return straddlers_; }

 private:
  void make_room(std::size_t more_entries);
  void divide_straddler(const ListEntry& entry, int axis, std::int32_t value);

  const std::vector<LatticeTriangle>& triangles_;
  std::unique_ptr<ListEntry[]> arena_;  // all lists
  std::size_t capacity_ = 0;            // entries for which the arena has room
  Index size_ = 0;                      // entries in use
  std::vector<ListEntry> above_;        // the upper child's list while a cell is divided
  std::vector<Index> straddlers_;       // numbers of entries
  Index root_size_ = 0;                 // entries of the root cell
};

}  // namespace kdm
