// SPDX-License-Identifier: MIT
// Which parts of the surface are small, and planes between parts: a split there meets no triangle,
// so it costs no hits.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "prepare/surface.h"
#include "split/split_rules.h"
#include "split/triangle_lists.h"

namespace kdm {

/// Parts are joined by edges. Of a surface that is one part nothing is ever said.
class PartCuts {
 public:
  explicit PartCuts(const Surface& surface);

  /// Are the triangles of parts with few triangles only?
  bool all_small(std::span<const ListEntry> entries) const;
  /// Are they of more parts than a window with its frame is?
  bool has_many_parts(std::span<const ListEntry> entries) const;

  /// The plane clear of all triangles that leaves the most of them on either side; nothing if
  /// there is none, or the triangles are all of one part.
  std::optional<Split> propose(std::span<const ListEntry> entries);

 private:
  std::vector<Index> part_;  // per triangle: the lowest triangle of its part
  std::vector<char> small_;  // per triangle: its part is
  std::vector<std::array<std::int32_t, 2>> extents_;  // of the triangles along the axis at hand
};

}  // namespace kdm
