// SPDX-License-Identifier: MIT
// Vertices for more than one feature in a leaf (paper 2.3.1).
#pragma once

#include "extract/place/place.h"

namespace kdm {

/// Splits each of the vertices that lies further off than the error: its ring is cut into sections
/// that one vertex each can serve. Returns the number of vertices added; each brings two triangles.
Index split_vertices(const GridView& view, const SplitError& error, VertexPosition position,
                     const std::vector<Index>& vertices, DualMesh& mesh);

}  // namespace kdm
