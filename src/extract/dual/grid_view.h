// SPDX-License-Identifier: MIT
// Bundles the parts of the grid that every step from loops to faces reads and none changes.
#pragma once

#include <span>
#include <vector>

#include "grid/grid_data.h"
#include "mesh/numbers.h"

namespace kdm {

/// Refers to a grid, to the boxes of its cells and to the surface points of its hits, which are
/// computed once for all steps. Owns nothing: what it refers to must outlive it. Cheap to copy.
struct GridView {
  const GridData& grid;
  std::span<const LatticeBox> boxes = {};  ///< per cell, from `cell_boxes`
  std::span<const Vec3> hit_points = {};   ///< per hit, in lattice coordinates, from `hit_points`
};

/// Computes the surface point of every hit, in lattice coordinates. With `apart`, hits that lie so
/// close together on an edge, or at a grid vertex, that their coordinates may become equal when
/// rounded to 32 bits are moved along their edge by a lattice unit or two. `boxes` are those of
/// `cell_boxes`.
std::vector<Vec3> hit_points(const GridData& grid, std::span<const LatticeBox> boxes,
                             bool apart = false);

}  // namespace kdm
