// SPDX-License-Identifier: MIT
// Adds the parts that a grid keeps as they are to the mesh that was made of its hits.
#pragma once

#include <cstdint>

#include "kdmanifold/extract.h"
#include "kdmanifold/mesh.h"

namespace kdm {

/// Appends the triangles of `exact`, a closed mesh, to those of `out`. Gives their corners normals
/// if the options ask for them.
void append_exact(const Mesh& exact, const ExtractOptions& options, Mesh& out);

/// Counts the pairs of triangles of two meshes, which share no vertices, that cross or touch.
std::uint64_t count_crossings(const Mesh& mesh, const Mesh& other);

}  // namespace kdm
