// SPDX-License-Identifier: MIT
// Parts of the result that are left out: on request, or because they are crumbs.
#pragma once

#include "kdmanifold/extract.h"

namespace kdm {

/// What `keep_parts` left out.
struct KeptParts {
  Index dropped = 0;  ///< parts left out, crumbs apart
  Index crumbs = 0;
  double invented_area = 0;  ///< of the kept faces that are of no input face, model units
};

/// Takes all parts out of a closed, oriented mesh but those that `wanted` says. Crumbs go in any
/// case: slivers between surfaces that lie within `tolerance` of each other but do not meet, next
/// to a hole that was closed. They have a face of no source, are thinner than the tolerance on
/// average, and enclose a void or are no larger than 16 times the tolerance.
KeptParts keep_parts(Parts wanted, double tolerance, Mesh& mesh);

}  // namespace kdm
