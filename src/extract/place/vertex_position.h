// SPDX-License-Identifier: MIT
// Finds the position of a vertex from the planes of its hits (paper 2.2.1).
#pragma once

#include <algorithm>
#include <span>

#include "extract/dual/grid_view.h"
#include "extract/place/face_settings.h"

namespace kdm {

/// Calls `visit(plane)` for the planes by which a vertex with these hits is placed. Planes of
/// invented hits (see `GridData::invented`) are left out unless all hits are invented: the input's
/// surface matters more than what closes its holes.
template <typename Visit>
void for_each_plane(const GridData& grid, std::span<const Index> hits, const Visit& visit) {
  const bool all = grid.stats.invented_hits == 0 ||
                   std::all_of(hits.begin(), hits.end(), [&](Index h) { return grid.invented(h); });
  for (const Index h : hits) {
    if (all || !grid.invented(h)) visit(grid.plane_of(h));
  }
}

/// Returns the point of the box with the least sum of squared distances to the planes of the hits.
/// If this point is not within the grid's tolerance of each plane, looks for a point of the box
/// that is, and returns it if one is found. With `VertexPosition::kProjection` returns the point of
/// the box that is nearest to the point of space where the sum is least.
Vec3 vertex_position(const GridView& view, std::span<const HitId> hits, const LatticeBox& box,
                     VertexPosition position);

/// Returns how far a vertex at this point may lie from the planes of the hits before it is split,
/// in lattice units.
double error_limit(const SplitError& error, const GridView& view, std::span<const HitId> hits,
                   const Vec3& vertex);

/// Returns the largest distance of the vertex from the planes of the hits, in lattice units.
double distance_to_planes(const GridData& grid, std::span<const HitId> hits, const Vec3& vertex);

/// Tells whether the vertex lies within this distance of the planes of all the hits.
bool meets_planes(const GridData& grid, std::span<const HitId> hits, const Vec3& vertex,
                  double distance);

}  // namespace kdm
