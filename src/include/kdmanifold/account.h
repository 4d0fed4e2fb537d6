// SPDX-License-Identifier: MIT
// Measures a result against its input: how far they are apart, and what of the input is missing.
#pragma once

#include <optional>
#include <vector>

#include "kdmanifold/deviation.h"
#include "kdmanifold/grid.h"
#include "kdmanifold/mesh.h"
#include "kdmanifold/warnings.h"

namespace kdm {

/// What of an input its result does not come near. Areas are in square model units.
struct LostArea {
  double area = 0;
  Index parts = 0;     ///< pieces joined by vertices
  double largest = 0;  ///< area of the largest piece
  double share = 0;    ///< `area` as a fraction of the input's whole area
  /// Not in `area`: what lies within the solid, so that the inside rule drops it. Where the input
  /// is closed, only walls with solid on both sides; a cavity that has been filled is lost.
  double inner_area = 0;
  std::vector<Index> faces;  ///< numbers of the input's triangles that are lost, in whole or part
};

/// What `compare` finds.
struct Account {
  LostArea lost;
  std::optional<MeshError> error;  ///< if it was asked for
  /// `AREA_LOST`, if more than a thousandth of the input's area is lost; graver than all others.
  /// `FAR_FROM_INPUT`, if the error was asked for and is more than one and a half tolerances, where
  /// `AREA_LOST` or holes that were closed do not account for it. `thicken`, `simplify` and sewing
  /// over wide gaps allow for as much more.
  std::vector<Warning> warnings;
};

/// What `compare` can be told.
struct CompareOptions {
  bool error = false;  ///< measure how far the two are apart; takes longer than all the rest
};

/// Holds a result against the mesh that its grid was built from: all its triangles as they were
/// given, but those without area once positions are rounded to the lattice.
///
/// Lost is what the result does not come near: it is further away than four tolerances of the grid,
/// or twice the distance of sewing, and with `thicken` than the thickness besides. Further faces
/// over the same corners do not count. Small faces that have hits, or neighbours with hits, are
/// taken to be there; the others are looked at in a point each, and in some 16,000 points spread
/// evenly over the whole area.
///
/// The error is measured at all vertices and at some 4,000 points spread evenly over the area of
/// either surface, its root mean square at every second of these. What lies within the solid and
/// more than a tolerance deep is left out of `to_output`; where the input is not closed, what
/// counts as `LostArea::inner_area`.
///
/// Of a loaded grid the inside rule is not known; it is taken to be `kRepair`. Takes n log n in the
/// faces; the same numbers everywhere. Throws `kInvalidMesh` if a face of either mesh names a
/// vertex that does not exist, or a coordinate is not finite or beyond 1e150.
Account compare(const Mesh& input, const Grid& grid, const Mesh& result,
                const CompareOptions& options = {});

}  // namespace kdm
