// SPDX-License-Identifier: MIT
// Which of a cell's triangles hang together within the cell or within one of its faces.
#pragma once

#include <span>
#include <vector>

#include "split/cell_triangles.h"

namespace kdm {

/// Groups of members that are connected through mesh edges within a box (union-find). One object
/// serves cell after cell.
class MemberGroups {
 public:
  /// Groups the members in `subset`: two of them are joined if they share a mesh edge that meets
  /// the cell.
  void connect(const CellTriangles& triangles, std::span<const MemberId> subset);
  /// Groups the members in `subset`: two of them are joined if they share a mesh edge that meets
  /// the face of the cell normal to `axis` at its low or high side.
  void connect_on_face(const CellTriangles& triangles, std::span<const MemberId> subset, int axis,
                       bool high);

  /// Returns the number of groups.
  Index count() const { return count_; }
  /// Returns how many mesh edges with a triangle on both sides meet the box.
  Index shared_edges() const { return shared_edges_; }
  /// Returns the subset's sides on the rim of the surface that meet the box.
  std::span<const SideId> rim_sides() const { return rim_sides_; }

  /// Tells whether the member was in the subset.
  bool contains(MemberId member) const { return parent_[member] != kNone; }
  /// Returns the lowest member of the group that a member of the subset is in.
  MemberId lowest(MemberId member) {
    while (parent_[member] != member) {
      member = parent_[member] = parent_[parent_[member]];
    }
    return member;
  }

 private:
  template <typename Meets>
  void join_where(const CellTriangles& triangles, std::span<const MemberId> subset,
                  const Meets& meets);

  std::vector<MemberId> parent_;  // per member; kNone outside of the subset
  std::vector<SideId> rim_sides_;
  Index count_ = 0;
  Index shared_edges_ = 0;
};

}  // namespace kdm
