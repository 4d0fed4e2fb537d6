// SPDX-License-Identifier: MIT
// Where vertices go (paper 2.2.1).
#pragma once

#include <span>
#include <utility>

#include "extract/dual/dual_mesh.h"
#include "extract/dual/grid_view.h"
#include "extract/place/face_settings.h"

namespace kdm {

/// The point of the box with the least squared distances to the hits' planes; where that is not
/// within the grid's tolerance of all of them, one that is, if there is one. Or the point nearest
/// to where the squared distances are least anywhere.
Vec3 vertex_position(const GridView& view, std::span<const Index> hits, const LatticeBox& box,
                     VertexPosition position);

/// Puts each loop's vertex near its hits' planes, kept within its leaf as `position` says; on the
/// boundary also near the planes through the rim; at corners that the grid keeps. Returns the other
/// vertices that lie further off than the error, but for those on the boundary: a split is not
/// defined there.
std::vector<Index> place_vertices(const GridView& view, const FaceSettings& settings,
                                  DualMesh& mesh);

/// Vertices for which the grid keeps corners, of which their hits do not tell, and these;
/// ascending.
std::vector<std::pair<Index, Vec3>> kept_corners(const GridData& grid, const DualMesh& mesh);

/// What the error comes to for a vertex of these hits.
double error_limit(const SplitError& error, const GridView& view, std::span<const Index> hits,
                   const Vec3& vertex);

/// The largest distance of the vertex from the planes of the hits.
double distance_to_planes(const GridData& grid, std::span<const Index> hits, const Vec3& vertex);

/// Does the vertex lie within this distance of the planes of all the hits?
bool meets_planes(const GridData& grid, std::span<const Index> hits, const Vec3& vertex,
                  double distance);

}  // namespace kdm
