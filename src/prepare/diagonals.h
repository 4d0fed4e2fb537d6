// SPDX-License-Identifier: MIT
// Quads that lie upon each other and are cut along different diagonals.
#pragma once

#include "mesh/numbers.h"
#include "prepare/faces.h"

namespace kdm {

/// Finds quads over the same four points that are cut into triangles along different diagonals, and
/// cuts them all like the first of them: so the back of a face comes to lie on its front, and
/// copies on what they are copies of. A quad is two triangles that share an edge with no other
/// and face about the same way; one of its outer edges at least has more than two triangles. Quads
/// whose diagonals are further apart than `tolerance`, in model units, are left as they are: what
/// is between them is solid. Returns how many quads were cut anew; if there are any, the topology
/// becomes invalid. Takes linear time up to sorting.
Index match_diagonals(InputFaces& faces, double tolerance);

}  // namespace kdm
