// SPDX-License-Identifier: MIT
// Which triangles meet a cell, exactly, and how far each of them reaches in it.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "geometry/triangle_box.h"
#include "prepare/surface.h"
#include "split/triangle_lists.h"

namespace kdm {

/// A triangle's number among those that meet the cell at hand.
using MemberId = Index;

/// Enlarges `bounds` until it holds `box` as well.
inline void widen(LatticeBox& bounds, const LatticeBox& box) {
  for (int i = 0; i < 3; ++i) {
    bounds.lo[i] = std::min(bounds.lo[i], box.lo[i]);
    bounds.hi[i] = std::max(bounds.hi[i], box.hi[i]);
  }
}

/// The triangles that meet one open cell, its *members*, in the order of the cell's list. One
/// object serves cell after cell.
class CellTriangles {
 public:
  explicit CellTriangles(const Surface& surface)
      : surface_(surface), member_of_(surface.triangles.size(), kNone) {}

  /// Finds the members of a cell. `entries` must hold every triangle that meets the cell and may
  /// hold others.
  void find(const LatticeBox& cell, std::span<const ListEntry> entries);

  const Surface& surface() const { return surface_; }
  const LatticeBox& cell() const { return cell_; }

  Index size() const { return static_cast<Index>(triangles_.size()); }
  bool empty() const { return triangles_.empty(); }
  std::span<const TriangleId> all() const { return triangles_; }
  TriangleId triangle(MemberId member) const { return triangles_[member]; }
  const LatticeTriangle& corners(MemberId member) const {
    return surface_.triangles[triangles_[member]];
  }
  /// Returns bounds of the member's part in the cell, rounded outwards.
  const LatticeBox& bounds(MemberId member) const { return bounds_[member]; }
  /// Returns which corners of a member lie in the cell, and beyond which of its sides the others.
  const Outcodes& outcodes(MemberId member) const { return outcodes_[member]; }
  /// Returns the face of the cell normal to `axis` at its low or high side, as a flat box.
  LatticeBox face(int axis, bool high) const {
    LatticeBox face = cell_;
    (high ? face.lo : face.hi)[axis] = (high ? face.hi : face.lo)[axis];
    return face;
  }
  /// Returns the member's outcodes for a face of the cell instead of the cell.
  Outcodes outcodes_at_face(MemberId member, int axis, bool high) const {
    const unsigned below = 1u << 2 * axis;
    const unsigned above = 2u << 2 * axis;
    Outcodes codes = outcodes_[member];
    for (Outcode& code : codes) {
      const bool is_above = high ? (code & above) != 0 : (code & below) == 0;
      code = static_cast<Outcode>((code & ~(below | above)) | (is_above ? above : below));
    }
    return codes;
  }
  /// Returns kNone for a triangle that does not meet the cell.
  MemberId member_of(TriangleId triangle) const { return member_of_[triangle]; }

 private:
  const Surface& surface_;
  LatticeBox cell_;
  std::vector<TriangleId> triangles_;  // per member
  std::vector<LatticeBox> bounds_;     // per member
  std::vector<Outcodes> outcodes_;     // per member
  std::vector<MemberId> member_of_;    // per triangle of the surface
};

}  // namespace kdm
