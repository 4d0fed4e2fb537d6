// SPDX-License-Identifier: MIT
// Finds which closed parts of a mesh lie inside which others.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mesh/polygons.h"

namespace kdm {

/// What `find_enclosures` must know of a part.
struct Shell {
  Box bounds;
  bool closed = false;  ///< every edge used equally often in both directions
};

/// Two closed parts, one of which lies in the other.
struct Enclosure {
  Index inner;
  Index outer;
};

/// Finds all pairs of closed parts of which one lies in the other, ascending by inner, then by
/// outer part. Whether a part lies in another one is judged by its outermost vertices along the
/// eight diagonals of space: each of them must lie on the outer part or where the outer part's
/// winding number is not 0, and at least one must not lie on the outer part. If all lie on it,
/// points amid some of its faces are judged instead: of those that do not lie on the outer part,
/// more must lie within than outside. What is closer than 1e-7 counts as on it, as parts that touch
/// do so but for rounding errors; for all else the signs are exact. Coordinates must be scaled to
/// about 1. `part_of` gives the part of each face, or kNone; `shells` describes the parts.
///
/// The number of pairs may grow with the square of the number of parts. Returns nothing if finding
/// them would take more than about a second.
std::optional<std::vector<Enclosure>> find_enclosures(const Polygons& faces,
                                                      std::span<const Vec3> positions,
                                                      std::span<const Index> part_of,
                                                      std::span<const Shell> shells);

}  // namespace kdm
