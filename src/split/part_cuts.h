// SPDX-License-Identifier: MIT
// Splits between the parts of a surface. A split whose plane meets no triangle adds no hits.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/marks.h"
#include "mesh/numbers.h"
#include "prepare/surface.h"
#include "split/split_rules.h"
#include "split/triangle_lists.h"

namespace kdm {

/// Knows the connected parts of a surface and finds planes between them. A part is a set of
/// triangles that are connected through shared edges. If the whole surface is one part, no part is
/// called small and no plane is found.
class PartCuts {
 public:
  /// Counts the triangles of the parts. Keeps a reference to the surface.
  explicit PartCuts(const Surface& surface);

  /// Tells whether all triangles of a cell's list belong to small parts: parts that have at most
  /// 512 triangles each.
  bool all_small(std::span<const ListEntry> entries) const;
  /// Tells whether the triangles of a cell's list belong to more than four parts. The surface must
  /// have several parts.
  bool has_many_parts(std::span<const ListEntry> entries) const;

  /// Returns a split of the cell whose plane meets none of the triangles in the cell's list, which
  /// must not be empty. Of several such splits it is the one with the most triangles on the side
  /// where they are fewer. Returns nothing if every plane meets triangles, or if all triangles
  /// belong to one part. Takes three sorts of the list.
  std::optional<Split> propose(std::span<const ListEntry> entries);

 private:
  std::span<const Index> part_of_;  // per triangle: its part; empty if there is one
  Marks in_small_part_;             // per triangle
  // The lower and upper bound of each triangle in the list along one axis, in lattice units.
  std::vector<std::uint64_t> extents_;
};

}  // namespace kdm
