// SPDX-License-Identifier: MIT
// Does a result bound the solid that its input describes? Asked at points away from the surface,
// by solid angles in floating point: a method of its own, with nothing of the lattice in it.
#pragma once

#include <functional>
#include <string>

#include "kdmanifold/mesh.h"

namespace kdm::check {

/// How often the mesh winds round the point, rounded; the mesh must be closed.
int winding_number(const Mesh& mesh, const Vec3& point);

/// Is the point further than `distance` from the box of every triangle?
bool clear_of(const Mesh& mesh, const Vec3& point, double distance);

/// Of `samples` random points in the input's box, those clear of its triangles: the result must
/// wind once round those that are `inside(winding of the input)` and not round the others. Returns
/// the first disagreement in words, "" if there is none, and counts the points that were compared.
std::string compare_solids(const Mesh& input, const Mesh& result,
                           const std::function<bool(int)>& inside, double distance, int samples,
                           int* compared = nullptr);

}  // namespace kdm::check
