// SPDX-License-Identifier: MIT
// Pieces of the surface within a cell.
//
// The surface within an (open) cell is a union of mesh vertices, open mesh edges and open
// triangles, each cut to a convex set. So its Euler characteristic is vertices - edges + triangles
// that meet the cell. Each piece that is a disk counts one, any other counts less, and a closed
// piece is known by its lack of crossings with the cell's edges.
// The rim of a sheet is left out of that sum, so that a half-disk counts as a disk, and looked at
// by itself: its parts in the cell are rim edges - rim vertices in number, and a piece may have
// one.
#include "split/cell_analysis.h"

#include <algorithm>
#include <cmath>

#include "geometry/triangle_box.h"
#include "geometry/triangle_triangle.h"
#include "mesh/box_tree.h"

namespace kdm {

namespace {

// Lies part of the polygon on (or within rounding of) the plane?
bool reaches_plane(const ClippedPolygon& polygon, const Plane& plane) {
  bool above = false;
  bool below = false;
  for (int i = 0; i < polygon.size; ++i) {
    const double distance = plane.signed_distance(polygon.corners[i]);
    // The planes are those before rounding to the lattice.
    above = above || distance > -1;
    below = below || distance < 1;
  }
  return above && below;
}

// Is the cell's edge (see `cell_edge`) part of the outline of this side?
bool lies_on_side(int edge, int axis, bool high) {
  const int along = edge / 4;
  if (along == axis) return false;
  return ((next_axis(along) == axis ? edge & 1 : edge & 2) != 0) == high;
}

}  // namespace

CellAnalysis::CellAnalysis(const Surface& surface)
    : surface_(surface), local_(surface.triangles.size(), kNone) {
  Index points = 0;
  for (const Triangle& t : surface.corners) points = std::max({points, t[0], t[1], t[2]});
  counted_.assign(std::size_t{points} + 1, 0);
  if (!surface.has_rims()) return;
  on_rim_.assign(std::size_t{points} + 1, 0);
  for (Index side = 0; side < surface.topology.opposite.size(); ++side) {
    if (surface.topology.opposite[side] != kNone) continue;
    const Triangle& t = surface.corners[side / 3];
    on_rim_[t[side % 3]] = on_rim_[t[next_corner(static_cast<int>(side % 3))]] = 1;
  }
}

Index CellAnalysis::find(Index i) {
  while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
  return i;
}

// `subset` holds member numbers; after the call, parent_ of each leads to its part's lowest.
Index CellAnalysis::count_parts(std::span<const Index> subset, const LatticeBox& box) {
  parent_.assign(members_.size(), kNone);
  for (const Index m : subset) parent_[m] = m;
  auto parts = static_cast<Index>(subset.size());
  edges_ = 0;
  rim_sides_.clear();
  for (const Index m : subset) {
    const Index triangle = members_[m];
    const LatticeTriangle& t = surface_.triangles[triangle];
    for (int i = 0; i < 3; ++i) {
      const Index side = 3 * triangle + static_cast<Index>(i);
      const SideId opposite = surface_.topology.opposite[side];
      if (opposite < side || !edge_meets_box(t[i], t[next_corner(i)], box)) continue;
      if (opposite == kNone) {
        rim_sides_.push_back(side);
        continue;
      }
      ++edges_;
      const Index other = local_[opposite / 3];
      if (other == kNone || parent_[other] == kNone) continue;
      const Index a = find(m);
      const Index b = find(other);
      if (a == b) continue;
      parent_[std::max(a, b)] = std::min(a, b);
      --parts;
    }
  }
  return parts;
}

void CellAnalysis::find_pieces(const LatticeBox& box, std::span<const ListEntry> entries,
                               const CellCrossings& crossings) {
  for (const Index triangle : members_) local_[triangle] = kNone;
  box_ = box;
  crossings_ = &crossings;
  members_.clear();
  bounds_.clear();
  for (const ListEntry& entry : entries) {
    if (!triangle_meets_box(surface_.triangles[entry.triangle], box)) continue;
    local_[entry.triangle] = static_cast<Index>(members_.size());
    members_.push_back(entry.triangle);
    bounds_.push_back({entry.lo, entry.hi});
  }
  subset_.clear();
  for (Index m = 0; m < members_.size(); ++m) subset_.push_back(m);
  const Index parts = count_parts(subset_, box);
  Index vertices = 0;
  ++counts_;
  for (const Index triangle : members_) {
    for (int i = 0; i < 3; ++i) {
      const Index point = surface_.corners[triangle][i];
      if (counted_[point] == counts_) continue;
      if (!vertex_in_box(surface_.triangles[triangle][i], box)) continue;
      counted_[point] = counts_;
      if (!surface_.has_rims() || on_rim_[point] == 0) ++vertices;
    }
  }
  euler_characteristic_ =
      std::int64_t{vertices} - edges_ + static_cast<std::int64_t>(members_.size());
  // A part's lowest member comes before its others: pieces are numbered in that order.
  pieces_.clear();
  pieces_.reserve(parts);
  piece_.resize(members_.size());
  for (Index m = 0; m < members_.size(); ++m) {
    const Index root = find(m);
    if (root == m) {
      piece_[m] = static_cast<Index>(pieces_.size());
      pieces_.push_back({.bounds = bounds_[m]});
    } else {
      piece_[m] = piece_[root];
    }
    widen(pieces_[piece_[m]].bounds, bounds_[m]);
  }
  cell_rims_ = rim_sides_;
  for (const Index side : cell_rims_) {
    Piece& piece = pieces_[piece_[local_[side / 3]]];
    ++piece.rims;
    // Each rim vertex is where one rim side starts.
    if (vertex_in_box(surface_.triangles[side / 3][side % 3], box)) --piece.rims;
  }
  for (const CellCrossing& crossing : crossings.all) {
    const Index m = local_[crossing.triangle];
    if (m == kNone) continue;
    Piece& piece = pieces_[piece_[m]];
    ++piece.crossings;
    piece.kept += crossing.kept ? 1 : 0;
    piece.edges |= 1u << crossing.edge;
  }
}

bool CellAnalysis::pieces_are_disks() const {
  if (euler_characteristic_ != static_cast<std::int64_t>(pieces_.size())) return false;
  return std::all_of(pieces_.begin(), pieces_.end(),
                     [](const Piece& piece) { return piece.crossings > 0 && piece.rims <= 1; });
}

std::optional<ClosedCurve> CellAnalysis::find_closed_curve() {
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool high : {false, true}) {
      LatticeBox face = box_;
      face.lo[axis] = face.hi[axis] = high ? box_.hi[axis] : box_.lo[axis];
      subset_.clear();
      for (Index m = 0; m < members_.size(); ++m) {
        const bool reaches =
            high ? bounds_[m].hi[axis] == box_.hi[axis] : bounds_[m].lo[axis] == box_.lo[axis];
        if (reaches && triangle_meets_box(surface_.triangles[members_[m]], face)) {
          subset_.push_back(m);
        }
      }
      if (subset_.empty()) continue;
      // Each open part of the section ends in two crossings, or in one and the rim.
      const Index parts = count_parts(subset_, face);
      const auto rims = static_cast<Index>(rim_sides_.size());
      const Index open = (crossings_->round_face[axis][high ? 1 : 0] + rims) / 2;
      if (parts == open && !part_ends_in_two_rims()) continue;
      return closed_curve(axis, high);
    }
  }
  return std::nullopt;
}

// The first of the parts just counted on a face that has no end.
ClosedCurve CellAnalysis::closed_curve(int axis, bool high) {
  ended_.assign(members_.size(), 0);
  const auto end_at = [&](Index triangle) {
    const Index m = local_[triangle];
    if (m != kNone && parent_[m] != kNone) ended_[find(m)] = 1;
  };
  for (const CellCrossing& crossing : crossings_->all) {
    if (lies_on_side(crossing.edge, axis, high)) end_at(crossing.triangle);
  }
  for (const Index side : rim_sides_) end_at(side / 3);
  for (const Index m : subset_) {
    if (ended_[find(m)] != 0) continue;
    const std::int32_t plane = high ? box_.hi[axis] : box_.lo[axis];
    return {axis, section_bounds(find(m), axis, plane), piece_[m]};
  }
  LatticeBox bounds = bounds_[subset_[0]];
  for (const Index m : subset_) widen(bounds, bounds_[m]);
  return {axis, bounds, piece_[subset_[0]]};
}

// Of a curve within the face, rounded outwards. Triangles reach further than their sections.
LatticeBox CellAnalysis::section_bounds(Index part, int axis, std::int32_t plane) {
  LatticeBox bounds{box_.hi, box_.lo};
  for (const Index m : subset_) {
    if (find(m) != part) continue;
    const LatticeTriangle& t = surface_.triangles[members_[m]];
    for (int i = 0; i < 3; ++i) {
      const LatticePoint& a = t[i];
      const LatticePoint& b = t[next_corner(i)];
      if (below_plane(a[axis], plane) == below_plane(b[axis], plane)) continue;
      const Vec3 point = to_vec3(a) + static_cast<double>(plane - a[axis]) / (b[axis] - a[axis]) *
                                          (to_vec3(b) - to_vec3(a));
      for (int k = 0; k < 3; ++k) {
        const double x = std::clamp<double>(point[k], box_.lo[k], box_.hi[k]);
        bounds.lo[k] = std::min(bounds.lo[k], static_cast<std::int32_t>(std::floor(x)));
        bounds.hi[k] = std::max(bounds.hi[k], static_cast<std::int32_t>(std::ceil(x)));
      }
    }
  }
  return bounds;
}

// Of the parts just counted on a face.
bool CellAnalysis::part_ends_in_two_rims() {
  for (std::size_t i = 1; i < rim_sides_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (find(local_[rim_sides_[i] / 3]) == find(local_[rim_sides_[j] / 3])) return true;
    }
  }
  return false;
}

std::optional<Index> CellAnalysis::find_pillow() {
  for (Index i = 0; i < pieces_.size(); ++i) {
    if (!pieces_[i].hangs_on_one_edge()) continue;
    const auto member = std::find(piece_.begin(), piece_.end(), i) - piece_.begin();
    if (part_is_near(members_[static_cast<std::size_t>(member)])) return i;
  }
  return std::nullopt;
}

// Is all that is connected with the triangle within the cell or its next neighbours' reach? Most
// searches end after a few steps.
bool CellAnalysis::part_is_near(Index triangle) {
  LatticeBox reach = box_;
  for (int i = 0; i < 3; ++i) {
    const std::int32_t extent = box_.hi[i] - box_.lo[i];
    reach.lo[i] -= extent;
    reach.hi[i] += extent;
  }
  visit_.resize(surface_.triangles.size(), 0);
  ++visits_;
  stack_.assign(1, triangle);
  visit_[triangle] = visits_;
  while (!stack_.empty()) {
    const Index t = stack_.back();
    stack_.pop_back();
    for (const LatticePoint& p : surface_.triangles[t]) {
      if (!vertex_in_box(p, reach)) return false;
    }
    for (Index side = 3 * t; side < 3 * t + 3; ++side) {
      if (surface_.topology.opposite[side] == kNone) return false;  // open: no volume to lose
      const Index other = surface_.topology.opposite[side] / 3;
      if (visit_[other] == visits_) continue;
      visit_[other] = visits_;
      stack_.push_back(other);
    }
  }
  return true;
}

// Of few members, those are compared whose bounds overlap along the cell's longest side.
bool CellAnalysis::triangles_cross() {
  constexpr std::size_t kFew = 1024;
  if (members_.size() > kFew) {
    std::vector<Box> boxes;
    boxes.reserve(members_.size());
    for (const LatticeBox& bounds : bounds_)
      boxes.push_back({to_vec3(bounds.lo), to_vec3(bounds.hi)});
    bool cross = false;
    BoxTree(boxes).for_each_pair([&](Index i, Index j) { cross = cross || members_cross(i, j); });
    return cross;
  }
  const int axis = longest_axis(box_);
  by_bound_.clear();
  for (Index m = 0; m < members_.size(); ++m) by_bound_.emplace_back(bounds_[m].lo[axis], m);
  std::sort(by_bound_.begin(), by_bound_.end());
  for (std::size_t i = 0; i < by_bound_.size(); ++i) {
    const Index first = by_bound_[i].second;
    for (std::size_t j = i + 1; j < by_bound_.size(); ++j) {
      if (by_bound_[j].first > bounds_[first].hi[axis]) break;
      if (members_cross(first, by_bound_[j].second)) return true;
    }
  }
  return false;
}

bool CellAnalysis::members_cross(Index i, Index j) const {
  for (int k = 0; k < 3; ++k) {
    if (bounds_[i].lo[k] > bounds_[j].hi[k] || bounds_[j].lo[k] > bounds_[i].hi[k]) return false;
  }
  const Index a = members_[i];
  const Index b = members_[j];
  if (surface_.degenerate.test(a) || surface_.degenerate.test(b)) return false;
  if (!TriangleCrossing<LatticeKernel>::test(surface_.triangles[a], surface_.corners[a],
                                             surface_.triangles[b], surface_.corners[b])) {
    return false;
  }
  // They may cross outside the cell.
  return reaches_plane(clip_to_box(surface_.triangles[a], box_), surface_.planes[b]) &&
         reaches_plane(clip_to_box(surface_.triangles[b], box_), surface_.planes[a]);
}

}  // namespace kdm
