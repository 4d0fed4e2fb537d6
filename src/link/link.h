// SPDX-License-Identifier: MIT
// Links half-edges across minimal faces (paper 2.1, 2.3.2).
#pragma once

#include <span>

#include "grid/grid_data.h"
#include "kdmanifold/build.h"
#include "prepare/surface.h"

namespace kdm {

/// Links all half-edges of a grid whose cells and hits are finished: fills `opposite`, `start` and
/// `rims`, and counts ambiguous and guessed faces. `triangle_of_hit` names the triangle of the
/// surface that makes each hit, kNone for invented hits. A solid's half-edges are all linked;
/// half-edges of a sheet that find no partner stay on the boundary. Throws if a solid's half-edge
/// has no partner, which can only happen if construction is at fault. Takes time linear in cells
/// and hits, except for faces with many hits (see link/match_face.h).
void link_half_edges(const Surface& surface, std::span<const TriangleId> triangle_of_hit,
                     Pairing pairing, GridData& grid);

}  // namespace kdm
