// SPDX-License-Identifier: MIT
// Removes the small handles of results.
#pragma once

#include "kdmanifold/mesh.h"
#include "mesh/progress.h"

namespace kdm {

/// How `drop_handles` goes about it.
struct HandleSettings {
  double smaller_than = 0;  ///< length of the loops that are cut, in model units
  double shift = 0;         ///< how far vertices beside a cut may be moved at most, in model units
  bool single = false;      ///< positions are rounded to 32 bits
};

/// How many handles were smaller than asked for.
struct DroppedHandles {
  Index dropped = 0;
  Index kept = 0;  ///< nothing closes them without meeting the surface
};

/// Removes handles from a closed, oriented, 2-manifold mesh of triangles. The size of a handle is
/// the length of the shortest closed walk along edges that goes round it, or through the tunnel
/// that it makes: there the surface is cut, the two rims are drawn apart, and each is closed by
/// triangles over its corners, or around its centre. So a tunnel is closed by a wall and a bridge
/// is cut through, at the narrowest place of either, and each time the mesh has one handle less.
/// What is new has no source face and meets nothing; where that cannot be had, the handle stays.
DroppedHandles drop_handles(const HandleSettings& settings, const Progress& progress, Mesh& mesh);

}  // namespace kdm
