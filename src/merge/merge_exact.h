// SPDX-License-Identifier: MIT
// Merges the thin parts that grids keep without cells.
#pragma once

#include "merge/grid_solid.h"
#include "merge/merge_function.h"

namespace kdm {

/// Returns the thin parts of two grids of one lattice that bound the merged solid, turned out of
/// it. `first_operand` has for each grid the number that its first operand gets. Throws
/// `kInvalidOption` if the box of such a part meets that of a triangle of the other grid's surface,
/// or of a thin part of it.
Mesh merge_exact(const std::array<const GridSolid*, 2>& solids, const MergeFunction& function,
                 const std::array<Index, 2>& first_operand);

}  // namespace kdm
