// SPDX-License-Identifier: MIT
// Makes closed surfaces of faces that are open or turned inconsistently.
#pragma once

#include "kdmanifold/build.h"
#include "prepare/faces.h"

namespace kdm {

/// Repairs faces that do not form closed surfaces, or that lie wholly back to back, for the rule
/// `kRepair`: sews rims together where they are no further apart than the tolerance, turns
/// neighbours to agree and parts to look outwards, and keeps one of several faces over the same
/// corners. If the surface is still not closed, `faces.repair` is set. The report says what was
/// done. `tolerance` is in model units. Throws `kNotClosed` if a hole is wider than the options
/// allow.
void repair_faces(InputFaces& faces, const BuildOptions& options, double tolerance);

/// Turns parts of closed surfaces that are inside out (see prepare/inverted_parts.h).
void turn_inverted_parts(InputFaces& faces);

}  // namespace kdm
