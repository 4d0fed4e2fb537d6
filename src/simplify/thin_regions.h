// SPDX-License-Identifier: MIT
// Bodies that are thin go, cavities that are thin are filled (paper 4.2: in-metric, out-metric).
#pragma once

#include "grid/grid_data.h"
#include "kdmanifold/progress.h"

namespace kdm {

/// What went. The surface that is left has so many closed surfaces and handles less.
struct GoneRegions {
  Index regions = 0;
  Index surfaces = 0;  ///< closed surfaces that bounded them
  Index handles = 0;   ///< that these had
  Index left = 0;      ///< closed surfaces that there still are; pillows do not count
};

/// Takes all bodies of material out of a solid's grid into which no ball fits that is wider than
/// `thickness` (lattice units), or fills all such cavities. Their hits go, and what the grid had of
/// them as it is; cells stay. A body goes with the cavities in it, but not with other bodies that
/// lie in these; a cavity is filled together with the bodies in it becoming one with what is round
/// it. Leaves what it does not know for sure: where surfaces meet or cross, so that nobody can tell
/// what lies in what.
GoneRegions take_thin_regions(GridData& grid, double thickness, bool material,
                              const Progress& progress);

}  // namespace kdm
