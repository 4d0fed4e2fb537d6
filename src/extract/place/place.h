// SPDX-License-Identifier: MIT
// Places the vertices of all loops of a grid (paper 2.2.1).
#pragma once

#include <utility>
#include <vector>

#include "extract/dual/dual_mesh.h"
#include "extract/dual/grid_view.h"
#include "extract/place/face_settings.h"

namespace kdm {

/// Gives each loop's vertex its position, within its leaf: by the planes of its hits as the
/// settings say (see `vertex_position`), on the boundary also by the planes through the input's
/// rim; if the grid keeps a corner for the loop, the vertex goes there. Returns, ascending, the
/// vertices that were placed by planes and lie further from these planes than the settings' split
/// error. In a simplified grid corners count before planes and rims, and `joined` is filled.
/// Vertices on the boundary are not returned, since a split is not defined there.
std::vector<LoopId> place_vertices(const GridView& view, const FaceSettings& settings,
                                   DualMesh& mesh);

/// Lists the vertices in whose leaves the grid keeps a corner of the input, which their hits do not
/// show, each with the position of the corner; vertices ascend.
std::vector<std::pair<LoopId, Vec3>> kept_corners(const GridData& grid, const DualMesh& mesh);

}  // namespace kdm
