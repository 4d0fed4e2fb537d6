// SPDX-License-Identifier: MIT
// Writes GLB files.
#pragma once

#include <string>

#include "kdmanifold/mesh.h"

namespace kdm::cli::glb {

/// Returns the bytes of a GLB file with one mesh: positions of 32 bits, indices of as many as are
/// needed, quads cut in two. With corner normals a vertex is there once for each of its normals.
/// Throws `kInvalidMesh` if a coordinate is not finite in 32 bits.
std::string write(const Mesh& mesh);

}  // namespace kdm::cli::glb
