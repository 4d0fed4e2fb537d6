// SPDX-License-Identifier: MIT
// Leaves parts of the result out: on request, or because they are crumbs (see `keep_parts`).
#pragma once

#include "kdmanifold/extract.h"

namespace kdm {

/// Shells too small to be kept, each with all that lies in it.
struct SmallShells {
  Index count = 0;
  double volume = 0;  ///< of the material that went or came, in model units
};

/// What `keep_parts` left out.
struct KeptParts {
  Index dropped = 0;  ///< number of parts left out because of `parts`
  Index crumbs = 0;
  SmallShells small_parts;     ///< left out because of `drop_parts`
  SmallShells small_cavities;  ///< filled because of `drop_cavities`
  double invented_area = 0;    ///< area of the kept faces that close holes, in squared model units
};

/// Keeps the parts of a closed, oriented mesh that the options name, and removes all others. Crumbs
/// are always removed. They are slivers between surfaces that lie within `tolerance` of each other
/// but do not meet, next to a hole that was closed. A crumb has a face that comes from no input
/// face, is thinner than the tolerance on average, and encloses a void or is no larger than 16
/// times the tolerance.
///
/// Shells are small by the diagonals of their bounding boxes: of those that are turned outwards
/// against `drop_parts`, of the others against `drop_cavities`.
KeptParts keep_parts(const ExtractOptions& options, double tolerance, Mesh& mesh);

/// Removes the parts of a closed, oriented mesh that have more than `most` times as much area of
/// faces that close holes as of other faces.
void drop_invented_parts(double most, Mesh& mesh);

}  // namespace kdm
