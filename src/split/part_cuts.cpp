// SPDX-License-Identifier: MIT
// A sweep along each axis over the triangles' bounds.
#include "split/part_cuts.h"

#include <algorithm>

#include "mesh/disjoint_sets.h"

namespace kdm {

namespace {

// Parts with more triangles are models of their own: how many cells they take is not for their
// topology to say.
constexpr Index kFewTriangles = 512;
constexpr std::size_t kFewParts = 4;

}  // namespace

PartCuts::PartCuts(const Surface& surface) {
  if (surface.topology.components <= 1) return;
  const auto triangles = static_cast<Index>(surface.triangles.size());
  DisjointSets parts(triangles);
  for (Index side = 0; side < 3 * triangles; ++side) {
    const SideId opposite = surface.topology.opposite[side];
    if (opposite != kNone && opposite < side) parts.join(side / 3, opposite / 3);
  }
  part_.reserve(triangles);
  std::vector<Index> size(triangles, 0);
  for (Index i = 0; i < triangles; ++i) {
    part_.push_back(parts.find(i));
    ++size[part_[i]];
  }
  small_.reserve(triangles);
  for (const Index part : part_) small_.push_back(size[part] <= kFewTriangles ? 1 : 0);
}

bool PartCuts::all_small(std::span<const ListEntry> entries) const {
  if (part_.empty()) return false;
  return std::all_of(entries.begin(), entries.end(),
                     [&](const ListEntry& entry) { return small_[entry.triangle] != 0; });
}

bool PartCuts::has_many_parts(std::span<const ListEntry> entries) const {
  std::array<Index, kFewParts> met;
  std::size_t count = 0;
  for (const ListEntry& entry : entries) {
    const Index part = part_[entry.triangle];
    if (std::find(met.begin(), met.begin() + count, part) != met.begin() + count) continue;
    if (count == kFewParts) return true;
    met[count++] = part;
  }
  return false;
}

std::optional<Split> PartCuts::propose(std::span<const ListEntry> entries) {
  if (part_.empty()) return std::nullopt;
  const Index first = part_[entries.front().triangle];
  if (std::all_of(entries.begin(), entries.end(),
                  [&](const ListEntry& entry) { return part_[entry.triangle] == first; })) {
    return std::nullopt;
  }
  std::optional<Split> best;
  std::size_t most = 0;
  std::int32_t widest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    extents_.clear();
    for (const ListEntry& entry : entries) extents_.push_back({entry.lo[axis], entry.hi[axis]});
    std::sort(extents_.begin(), extents_.end());
    std::int32_t reach = extents_[0][1];
    for (std::size_t i = 1; i < extents_.size(); ++i) {
      const std::int32_t gap = extents_[i][0] - reach;
      reach = std::max(reach, extents_[i][1]);
      if (gap < 2) continue;  // the plane lies off both
      const std::size_t fewer = std::min(i, extents_.size() - i);
      if (fewer < most || (fewer == most && gap <= widest)) continue;
      best = Split{axis, extents_[i][0] - gap + gap / 2};
      most = fewer;
      widest = gap;
    }
  }
  return best;
}

}  // namespace kdm
