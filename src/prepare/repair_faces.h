// SPDX-License-Identifier: MIT
// Makes closed surfaces of faces that are open, torn, doubled or turned inconsistently.
#pragma once

#include "kdmanifold/build.h"
#include "prepare/faces.h"

namespace kdm {

/// Repairs faces that do not form closed surfaces, or that lie wholly back to back, for the rule
/// `kRepair`:
/// - Rims no further apart than the tolerance are sewn together; further ones too if most rims are
///   torn apart that far.
/// - Neighbours are turned to agree, parts to look outwards; of several faces over the same corners
///   one is kept.
/// - Holes of parts that bound a solid are closed by patches. Sheets, which bound nothing, are left
///   out if they have little area.
///
/// Where that does not close the surface, because sheets stay or since the options ask for a
/// winding threshold, `faces.repair` is set. The report says what was done. `tolerance` is in model
/// units. Throws `kNotClosed` if a hole is wider than the options allow.
void repair_faces(InputFaces& faces, const BuildOptions& options, double tolerance);

/// Turns parts of closed surfaces that are inside out (see prepare/inverted_parts.h).
void turn_inverted_parts(InputFaces& faces);

}  // namespace kdm
