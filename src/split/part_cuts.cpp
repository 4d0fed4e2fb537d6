// SPDX-License-Identifier: MIT
// Finds planes between parts by a sweep along each axis over the triangles' bounds.
#include "split/part_cuts.h"

#include <algorithm>
#include <array>

#include "mesh/sort.h"

namespace kdm {

namespace {

// A part with at most this many triangles is small. The topology of small parts is looked after
// before their fit; parts with more triangles are models of their own.
constexpr Index kMostTrianglesOfSmallPart = 512;
// More parts than this are many. A window and the parts of its frame are not yet many.
constexpr std::size_t kFewParts = 4;

std::int32_t upper_bound_of(std::uint64_t extent) {
  return static_cast<std::int32_t>(second_of_pair(extent));
}

}  // namespace

PartCuts::PartCuts(const Surface& surface) {
  if (surface.topology.components > 1) part_of_ = surface.part_of;
  std::vector<Index> triangles_of(part_of_.size(), 0);  // per part
  for (const Index part : part_of_) ++triangles_of[part];
  in_small_part_.reserve(part_of_.size());
  for (const Index part : part_of_) {
    in_small_part_.push_back(triangles_of[part] <= kMostTrianglesOfSmallPart);
  }
}

bool PartCuts::all_small(std::span<const ListEntry> entries) const {
  if (part_of_.empty()) return false;
  return std::all_of(entries.begin(), entries.end(),
                     [&](const ListEntry& entry) { return in_small_part_.test(entry.triangle); });
}

bool PartCuts::has_many_parts(std::span<const ListEntry> entries) const {
  std::array<Index, kFewParts> met;
  std::size_t count = 0;  // of the parts that were met
  for (const ListEntry& entry : entries) {
    const Index part = part_of_[entry.triangle];
    if (std::find(met.begin(), met.begin() + count, part) != met.begin() + count) continue;
    if (count == kFewParts) return true;
    met[count++] = part;
  }
  return false;
}

std::optional<Split> PartCuts::propose(std::span<const ListEntry> entries) {
  if (part_of_.empty()) return std::nullopt;
  const Index first = part_of_[entries.front().triangle];
  if (std::all_of(entries.begin(), entries.end(),
                  [&](const ListEntry& entry) { return part_of_[entry.triangle] == first; })) {
    return std::nullopt;
  }
  std::optional<Split> best;
  std::size_t most_on_poorer_side = 0;
  std::int32_t widest_gap = 0;
  for (int axis = 0; axis < 3; ++axis) {
    extents_.clear();
    for (const ListEntry& entry : entries) {
      extents_.push_back(pack_pair(entry.lo[axis], static_cast<std::uint32_t>(entry.hi[axis])));
    }
    sort_numbers(extents_);
    std::int32_t reach = upper_bound_of(extents_[0]);
    for (std::size_t i = 1; i < extents_.size(); ++i) {
      const std::int32_t lower_bound = first_of_pair(extents_[i]);
      const std::int32_t gap = lower_bound - reach;
      reach = std::max(reach, upper_bound_of(extents_[i]));
      if (gap < 2) continue;  // the plane must touch neither of the triangles beside it
      const std::size_t on_poorer_side = std::min(i, extents_.size() - i);
      if (on_poorer_side < most_on_poorer_side ||
          (on_poorer_side == most_on_poorer_side && gap <= widest_gap)) {
        continue;
      }
      best = Split{axis, lower_bound - gap + gap / 2};
      most_on_poorer_side = on_poorer_side;
      widest_gap = gap;
    }
  }
  return best;
}

}  // namespace kdm
