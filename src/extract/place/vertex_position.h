// SPDX-License-Identifier: MIT
// Where a vertex goes that stands for the planes of some hits (paper 2.2.1).
#pragma once

#include <algorithm>
#include <span>

#include "extract/dual/grid_view.h"
#include "extract/place/face_settings.h"

namespace kdm {

/// Calls `visit(plane)` for the planes that a vertex with these hits stands for. Planes of invented
/// hits (see `GridData::invented`) count only where there are no others: the surface counts for
/// more than what closes it.
template <typename Visit>
void for_each_plane(const GridData& grid, std::span<const Index> hits, const Visit& visit) {
  const bool all = grid.stats.invented_hits == 0 ||
                   std::all_of(hits.begin(), hits.end(), [&](Index h) { return grid.invented(h); });
  for (const Index h : hits) {
    if (all || !grid.invented(h)) visit(grid.plane_of(h));
  }
}

/// Returns the point of the box with the least sum of squared distances to the planes of the hits.
/// Where that is not within the grid's tolerance of each plane, returns a point that is, if there
/// is one. With `VertexPosition::kProjection` returns the point of the box that is nearest to where
/// the sum is least anywhere.
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
