// SPDX-License-Identifier: MIT
// Vertices for all loops of a grid (paper 2.2.1).
#pragma once

#include <utility>
#include <vector>

#include "extract/dual/dual_mesh.h"
#include "extract/dual/grid_view.h"
#include "extract/place/face_settings.h"

namespace kdm {

/// Gives each loop's vertex its position, within its leaf: by the planes of its hits as the
/// settings say (see `vertex_position`), on the boundary also by the planes through the input's
/// rim; at the corner that the grid keeps in the leaf, if there is one. Returns the vertices by
/// planes alone that lie further off these than the settings' split error, ascending, but none on
/// the boundary, where a split is not defined.
std::vector<LoopId> place_vertices(const GridView& view, const FaceSettings& settings,
                                   DualMesh& mesh);

/// Lists the vertices in whose leaves the grid keeps a corner of the input, which their hits do not
/// tell of, with these corners; vertices ascend.
std::vector<std::pair<LoopId, Vec3>> kept_corners(const GridData& grid, const DualMesh& mesh);

}  // namespace kdm
