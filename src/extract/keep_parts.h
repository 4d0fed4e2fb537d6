// SPDX-License-Identifier: MIT
// Leaves parts of the result out: on request, or because they are crumbs (see `keep_parts`).
#pragma once

#include "kdmanifold/extract.h"

namespace kdm {

/// What `keep_parts` left out.
struct KeptParts {
  Index dropped = 0;  ///< number of parts left out, not counting crumbs
  Index crumbs = 0;
  double invented_area = 0;  ///< area of the kept faces that close holes, in squared model units
};

/// Keeps the parts of a closed, oriented mesh that `wanted` names, and removes all others. Crumbs
/// are always removed. They are slivers between surfaces that lie within `tolerance` of each other
/// but do not meet, next to a hole that was closed. A crumb has a face that comes from no input
/// face, is thinner than the tolerance on average, and encloses a void or is no larger than 16
/// times the tolerance.
KeptParts keep_parts(Parts wanted, double tolerance, Mesh& mesh);

/// Removes the parts of a closed, oriented mesh that have more than `most` times as much area of
/// faces that close holes as of other faces.
void drop_invented_parts(double most, Mesh& mesh);

}  // namespace kdm
