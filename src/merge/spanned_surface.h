// SPDX-License-Identifier: MIT
// The surface that a grid spans by itself, without the mesh that it was built from.
//
// Every hit is a point of it, every link a point of its minimal face and every loop the vertex that
// extraction gives it, a point of its leaf. Round each hit lie six triangles of hit, link and loop.
// So what the surface has of a leaf lies in this leaf, it meets the minimal faces in lines from hit
// to hit as they are linked, and the grid's edges in the hits.
#pragma once

#include <vector>

#include "grid/grid_data.h"
#include "prepare/surface.h"

namespace kdm {

/// Triangles of a grid's surface, rounded to the lattice.
struct SpannedSurface {
  static constexpr int kHit = 2;  ///< the corner of a triangle that is a hit

  std::vector<LatticePoint> points;
  std::vector<PointId> point_of_hit;  ///< hits on both sides of a strip are one point
  std::vector<Triangle> corners;      ///< per triangle; they form closed surfaces
  std::vector<HitId> hit;             ///< per triangle, ascending: the hit that it has for a corner
  std::vector<CellId> leaf;           ///< per triangle: the leaf in which it lies
};

/// Spans the surface of a solid's grid. Takes time linear in the hits. `boxes` come from
/// `cell_boxes`.
SpannedSurface span_surface(const GridData& grid, const std::vector<LatticeBox>& boxes);

}  // namespace kdm
