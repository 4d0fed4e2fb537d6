// SPDX-License-Identifier: MIT
// Reads GLB files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "kdmanifold/mesh.h"
#include "kdmanifold/warnings.h"

namespace kdm::cli::glb {

/// What is read of a file.
struct Scene {
  Mesh mesh;                      ///< all meshes of the scene, where its nodes put them
  std::vector<Warning> warnings;  ///< what was left out
};

/// Reads the default scene of a GLB file: triangles, strips and fans; what is mirrored is turned
/// back. Without a scene all nodes are read, without nodes all meshes. Throws `kParseError`, also
/// if meshes are compressed or lie in other files.
Scene read(std::string_view bytes, const std::string& name);

}  // namespace kdm::cli::glb
