// SPDX-License-Identifier: MIT
// Tells parts of an open surface that bound a solid from sheets, which bound nothing.
#pragma once

#include <span>
#include <vector>

#include "mesh/marks.h"
#include "mesh/numbers.h"
#include "prepare/holes.h"
#include "prepare/patches.h"

namespace kdm {

/// The parts of a surface that are sheets.
struct Sheets {
  Marks triangles;            ///< per triangle: it belongs to a sheet
  Marks useless_patches;      ///< per patch: it would close a sheet, or turn a part outside in
  Marks wide_patches;         ///< per patch: those of its part have more than a quarter of its area
  Index parts = 0;            ///< how many parts are sheets
  double area = 0;            ///< of the sheets, in squared units of the points
  double largest = 0;         ///< area of the largest one
  double area_of_solids = 0;  ///< of the other parts, without patches
};

/// Finds the sheets among the parts of a surface. Triangles belong to one part if sides of theirs
/// are opposite to each other, or if a patch closes holes of both. Parts without holes are no
/// sheets. A part with holes is one if
/// - most of its area is marked in `seen_from_both_sides`, or
/// - one patch nearly closes it and has nearly the area of the part: it is nearly flat, or
/// - several patches close it and have far more area than the part: it is a narrow band, or
/// - its patches are large and it encloses next to nothing with them.
///
/// Patches are useless, too, if they pass behind much of a part that is no sheet: such faces have
/// the outside of the patched part behind them (see `share_outside_in`). The outside of a tub may
/// end half way down, above its floor; a patch there has the floor on the wrong side.
Sheets find_sheets(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                   std::span<const SideId> opposite, const std::vector<Hole>& holes,
                   const std::vector<Patch>& patches, const Marks& seen_from_both_sides);

}  // namespace kdm
