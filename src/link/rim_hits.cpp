// SPDX-License-Identifier: MIT
// Makes and sorts the rim hits of a grid.
#include "link/rim_hits.h"

#include <algorithm>

#include "prepare/rim.h"

namespace kdm {

RimHit rim_hit(const Surface& surface, const MinimalFace& face, HalfEdgeId half_edge, SideId side) {
  return {half_edge, rim_point(surface, side, face.axis, face.plane),
          rim_plane(surface, side, surface.planes[side / 3].normal).normal};
}

void sort_rims(GridData& grid) {
  std::sort(grid.rims.begin(), grid.rims.end(),
            [](const RimHit& a, const RimHit& b) { return a.half_edge < b.half_edge; });
  grid.rims.shrink_to_fit();
}

}  // namespace kdm
