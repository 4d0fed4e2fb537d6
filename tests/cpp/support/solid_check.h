// SPDX-License-Identifier: MIT
// Tells whether a result bounds the solid that its input describes. Compares winding numbers at
// points away from the surface, found by solid angles in floating point: a method that shares
// nothing with the library.
#pragma once

#include <functional>
#include <string>

#include "kdmanifold/mesh.h"

namespace kdm::check {

/// Returns how often a closed mesh winds round the point.
int winding_number(const Mesh& mesh, const Vec3& point);

/// Tells whether the point is at least `distance` away from the box or the plane of every triangle.
bool clear_of(const Mesh& mesh, const Vec3& point, double distance);

/// Compares the solids of input and result at random points in the input's box. Points that are not
/// `clear_of` the input are left out of the `samples`. Round the others the input winds w times;
/// the result must wind once if `inside(w)`, else not at all. Returns the first disagreement in
/// words, or
/// "" if there is none. `compared`, if given, is increased by the number of points compared.
std::string compare_solids(const Mesh& input, const Mesh& result,
                           const std::function<bool(int)>& inside, double distance, int samples,
                           int* compared = nullptr);

}  // namespace kdm::check
