// SPDX-License-Identifier: MIT
// A grid as a solid: what lies inside of it at any lattice point, and where its surface crosses any
// line along an axis.
//
// On the grid's own edges the hits decide both, exactly. Elsewhere its spanned surface does
// (merge/spanned_surface.h), whose crossings are found exactly too. Its points are rounded to the
// lattice, so that within a lattice unit of a hit the two may disagree; who asks about a stretch of
// a line settles that by the signs at its ends.
#pragma once

#include <span>
#include <vector>

#include "merge/grid_line.h"
#include "merge/spanned_surface.h"

namespace kdm {

/// Where a line leaves or enters the solid.
struct SolidCrossing {
  LinePosition position;
  Index triangle;  ///< of the spanned surface; one at the hit, on the grid's edges
  bool leaving;    ///< upwards along the line
};

/// Refers to the grid, which must outlive it.
class GridSolid {
 public:
  explicit GridSolid(const GridData& grid);

  const GridData& grid() const { return grid_; }
  const SpannedSurface& surface() const { return surface_; }
  const std::vector<LatticeBox>& boxes() const { return boxes_; }
  /// Tells whether the surface reaches into one of the leaves in a cell.
  bool has_surface(CellId cell) const { return has_surface_[cell] != 0; }
  /// Returns the triangles of the spanned surface in a leaf.
  std::span<const Index> triangles_in(CellId leaf) const;
  /// Returns the corners of a triangle of the spanned surface.
  LatticeTriangle triangle(Index number) const;

  /// Tells whether a lattice point, shifted by (e, e^2, e^3), is inside.
  bool inside(const LatticePoint& point) const;
  /// Appends the crossings of the line along `axis` through `on_line` that lie between two
  /// coordinates, ascending.
  void find_crossings(int axis, const LatticePoint& on_line, std::int32_t low, std::int32_t high,
                      std::vector<SolidCrossing>& found) const;
  /// Returns a hit that is no further than `distance` lattice units from a point and lies on a grid
  /// edge with it; kNone if there is none.
  HitId hit_beside(const LatticePoint& point, std::int32_t distance) const;
  /// Returns the triangle of the spanned surface that the grid edge of a hit crosses at the hit.
  Index triangle_of(HitId hit) const { return triangle_of_hit_[hit]; }
  /// Counts the leaves with surface in a cell that a plane would cut within a box.
  Index count_cut(CellId cell, const LatticeBox& box, int axis, std::int32_t value) const;

 private:
  void find_triangles_of_hits();
  bool inside_on_edge(EdgeId edge, std::int32_t at) const;
  bool inside_by_surface(const LatticePoint& point) const;
  void cross_leaf(CellId leaf, int axis, const LatticePoint& on_line, std::int32_t low,
                  std::int32_t high, std::vector<SolidCrossing>& found) const;

  const GridData& grid_;
  std::vector<LatticeBox> boxes_;
  std::vector<std::uint8_t> signs_;       // per cell, see `corner_signs`
  std::vector<std::uint8_t> edge_signs_;  // per splitting edge: its low end is inside
  SpannedSurface surface_;
  std::vector<Index> triangles_begin_;  // per cell: of `triangles_of_`
  std::vector<Index> triangles_of_;     // leaf by leaf
  std::vector<Index> triangle_of_hit_;
  std::vector<char> has_surface_;
};

}  // namespace kdm
