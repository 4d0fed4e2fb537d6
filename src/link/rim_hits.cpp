// SPDX-License-Identifier: MIT
// Makes and sorts the rim hits of a grid.
#include "link/rim_hits.h"

#include "mesh/sort.h"
#include "prepare/rim.h"

namespace kdm {

RimHit rim_hit(const Surface& surface, const MinimalFace& face, HalfEdgeId half_edge, SideId side) {
  return {half_edge, rim_point(surface, side, face.axis, face.plane),
          rim_plane(surface, side, surface.planes[side / 3].normal).normal};
}

void sort_rims(GridData& grid) {
  sort_by(grid.rims, [](const RimHit& a, const RimHit& b) { return a.half_edge < b.half_edge; });
  grid.rims.shrink_to_fit();
}

}  // namespace kdm
