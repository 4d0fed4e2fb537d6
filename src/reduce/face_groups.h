// SPDX-License-Identifier: MIT
// Which group each triangle of a mesh is in.
#pragma once

#include <vector>

#include "kdmanifold/mesh.h"

namespace kdm {

/// Throws `kInvalidOption` unless there is a group for each face: by its source, if the mesh has
/// sources, else by its number. Without any groups everything is right.
void check_groups(const Mesh& mesh, const std::vector<Index>& of_sources);

/// Returns the group of each triangle, kNone for those without a source, once quads are cut into
/// two behind the triangles. Empty if there are no groups.
std::vector<Index> face_groups(const Mesh& mesh, const std::vector<Index>& of_sources);

}  // namespace kdm
