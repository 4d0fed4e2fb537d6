// SPDX-License-Identifier: MIT
// Turns the faces of the input into triangles over welded points, checks them, and repairs them as
// far as the inside rule needs.
#pragma once

#include "kdmanifold/build.h"
#include "kdmanifold/mesh.h"
#include "prepare/faces.h"

namespace kdm {

/// Returns how far the result may be from the input, in model units. `extent` is that of the input
/// (see `InputReport::extent`).
inline double tolerance_of(const BuildOptions& options, double extent) {
  return options.tolerance > 0 ? options.tolerance : options.relative_tolerance * extent;
}

/// Returns whether cells are split until the result is within the tolerance.
inline bool goes_by_tolerance(const BuildOptions& options) {
  return options.strategy != SplitStrategy::kUniform &&
         options.strategy != SplitStrategy::kMedian && options.cells == 0;
}

/// Checks the mesh and turns it into welded triangles. Of the options, the inside rule, the
/// tolerance and the largest hole count.
///
/// Closed input loses pairs of faces that lie back to back. Under the rule `kRepair`, parts of it
/// that are inside out are turned (see prepare/inverted_parts.h), and other input is repaired (see
/// prepare/repair_faces.h); if that closes the surface, it is treated like closed input. A sheet
/// may be open, and its faces stay as they are.
///
/// Throws `kInvalidMesh` (no triangles, index out of range, coordinate not finite or beyond 1e150)
/// and `kNotClosed` (the input is open under a rule that accepts closed input only, or has holes
/// too wide to be closed).
InputFaces prepare_faces(const Mesh& mesh, const BuildOptions& options);

/// Does what is left to do under the rule `kRepair` once all parts are closed: faces that lie back
/// to back and copies of parts are left out, and parts that are inside out are turned.
void tidy_closed_parts(InputFaces& faces);

}  // namespace kdm
