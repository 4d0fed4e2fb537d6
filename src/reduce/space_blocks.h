// SPDX-License-Identifier: MIT
// Cuts space into blocks with about as many triangles of a mesh each, so that what happens in one
// block can be worked out without the others.
#pragma once

#include <vector>

#include "kdmanifold/types.h"
#include "mesh/numbers.h"

namespace kdm {

/// A part of space: a box without its sides at the maximum. The blocks of a mesh fill all space and
/// do not overlap, so the outer ones have no end.
struct SpaceBlock {
  Box box;
  std::vector<TriangleId> triangles;  ///< those that may reach into the box, ascending
};

/// Tells whether the point is in the box of a block.
inline bool holds(const Box& box, const Vec3& p) {
  return (p.array() >= box.min.array()).all() && (p.array() < box.max.array()).all();
}

/// Cuts space in two again and again, where the part `below` (0 to 1) of the triangles' centres is
/// on the lower side, until no block has more than `most` triangles or cutting parts them no more.
/// `boxes` has the box round each triangle; triangles whose boxes are empty are in no block.
std::vector<SpaceBlock> cut_space(const std::vector<Box>& boxes, Index most, double below);

}  // namespace kdm
