// SPDX-License-Identifier: MIT
// Which hits of a merged grid are hits of the grids that it was made from, and what is taken over
// with them: planes, links, rims and corners.
#pragma once

#include <span>
#include <vector>

#include "merge/grid_solid.h"
#include "prepare/surface.h"

namespace kdm {

/// Where a hit of the merged grid comes from.
struct HitOrigin {
  int solid = 0;        ///< 0 or 1
  HitId hit = kNone;    ///< of that solid's grid
  bool kept = false;    ///< it is that hit; if not, it lies on the surface which that hit spans
  bool turned = false;  ///< what was inside there is outside now
};

/// Finds the origin of every hit. `triangle_of_hit` is what construction has returned.
std::vector<HitOrigin> find_origins(const std::array<const GridSolid*, 2>& solids,
                                    const Surface& surface,
                                    std::span<const TriangleId> triangle_of_hit,
                                    const GridData& merged);

/// Gives the hits their planes, turned out of the merged solid, with source faces and operands:
/// kept hits, and those on triangles of `surface` that lie in the plane of their origin, have that
/// of their origin, as many as there are different ones. All others have that of their triangle.
void take_planes(const std::array<const GridSolid*, 2>& solids, const Surface& surface,
                 std::span<const TriangleId> triangle_of_hit, const std::vector<HitOrigin>& origins,
                 GridData& merged);

/// Links half-edges as they were linked, in minimal faces between two leaves of one solid where all
/// hits are kept ones; then takes over rims and corners, in leaves where the other solid has no
/// surface. All half-edges must be linked.
void take_links(const std::array<const GridSolid*, 2>& solids,
                const std::vector<HitOrigin>& origins, GridData& merged);

}  // namespace kdm
