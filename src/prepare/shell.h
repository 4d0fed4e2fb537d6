// SPDX-License-Identifier: MIT
// Puts a shell around a surface: a layer on either side, and walls where layers end.
#pragma once

#include <span>

#include "kdmanifold/mesh.h"
#include "kdmanifold/types.h"
#include "mesh/marks.h"
#include "prepare/pieces_of_surface.h"

namespace kdm {

/// Makes a shell around the wanted triangles of a surface, half of the thickness to either side;
/// they must be joined to no others. It is closed and consistently oriented by construction: each
/// layer's face ends where the layer ends, and a wall leads from there down to the surface, or to
/// the other layer's face if both end. `source` says for each triangle which face its triangles
/// name.
Mesh make_shell(const PiecesOfSurface& surface, double thickness, std::span<const Index> source,
                const Marks& wanted);

}  // namespace kdm
