// SPDX-License-Identifier: MIT
// The cells of an earlier construction, for one of the same solids of which some have moved: where
// nothing has changed, cells and crossings are taken over as they are.
//
// What construction makes of a cell follows from the way of splits that leads to it, from the
// solids that have triangles in its list, and from its border. The list itself need not be
// compared: a solid that was not left out on the way has all those of its triangles in the list
// that may reach the cell.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "construct/cell_border.h"
#include "construct/made_cells.h"
#include "prepare/surface.h"

namespace kdm {

/// A set of solids: a bit for each.
using SolidBits = std::uint64_t;
/// With more solids than this nothing is taken over.
inline constexpr std::size_t kMostSolidBits = 64;

/// What construction notes of a cell that it splits.
struct SplitNote {
  SolidBits solids = 0;         ///< those with triangles in the cell's list
  bool several_solids = false;  ///< some of these may still have to be left out
  SplitId end = 0;              ///< the first split after those within the cell
  std::size_t fine_splits = 0;  ///< within the cell (see SplitRule::Tally)
  Index unresolved_begin = 0;   ///< range of `FormerCells::unresolved`: leaves within the cell
  Index unresolved_end = 0;
};

/// All that one construction keeps for the next.
struct FormerCells : MadeCells {
  bool complete = false;  ///< it may be used: no budget was ever exceeded
  std::vector<SplitNote> splits;
  SplitId taken_over = 0;  ///< how many splits come from the construction before
};

/// What a construction may take over, and what it is to keep.
struct CellMemory {
  const FormerCells* former = nullptr;  ///< of the same solids; null: nothing can be taken over
  SolidBits moved = 0;                  ///< solids that have changed since
  FormerCells* notes = nullptr;         ///< to be filled for the next one; null: nothing is kept
};

/// A cell of an earlier construction.
struct FormerCell : CellBorder {
  CellId cell = 0;
};

/// Returns the halves of a cell that is no leaf.
std::array<FormerCell, 2> halves_of(const FormerCell& cell, const FormerCells& former);

/// Tells whether the borders of two cells are the same, and no crossing on them is of a solid that
/// has moved.
bool same_border(const CellBorder& a, const std::vector<ClassifiedCrossing>& crossings_of_a,
                 const CellBorder& b, const std::vector<ClassifiedCrossing>& crossings_of_b,
                 const Surface& surface, SolidBits moved);

/// Appends all splits within a cell of an earlier construction to what is made, where they are in
/// `cell`, and to what is noted. Nothing within that cell may have been made before.
void copy_splits(const FormerCells& former, CellId former_cell, CellId cell, MadeCells& made,
                 FormerCells& notes);

}  // namespace kdm
