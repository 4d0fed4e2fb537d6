// SPDX-License-Identifier: MIT
// Closes the holes of a surface by patches.
#pragma once

#include <span>
#include <vector>

#include "mesh/numbers.h"
#include "prepare/holes.h"

namespace kdm {

/// What closes a hole, or several that lie in one plane and in each other.
struct Patch {
  std::vector<Index> holes;  ///< their numbers
  std::vector<Triangle> triangles;
  double area = 0;      ///< of the triangles
  bool narrow = false;  ///< no wider than the flatness, so that the triangles' planes mean nothing
  Vec3 normal = Vec3::Zero();  ///< of a flat patch: unit vector, as its triangles are turned; of
                               ///< others: zero
  Vec3 point = Vec3::Zero();   ///< of a flat patch: a point of its plane
};

/// Makes patches for all holes of a surface, over their corners, so that every side of a hole has
/// an opposite. Nothing is moved, and no point is added.
///
/// A hole whose corners lie within `flatness` of a plane, in the units of `points`, is closed by
/// triangles in that plane. Holes in one plane that lie in each other and run round opposite ways
/// are closed as one area with holes in it. Other holes get the patch of least area (see
/// prepare/least_area_patch.h). Patches may cross each other and the surface. Takes time linear in
/// the sides of large holes, but for sorting.
std::vector<Patch> make_patches(std::span<const Triangle> triangles,
                                const std::vector<Vec3>& points, const std::vector<Hole>& holes,
                                double flatness);

}  // namespace kdm
