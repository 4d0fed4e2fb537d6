// SPDX-License-Identifier: MIT
// Finds which closed parts of a mesh lie in which.
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
/// outer part. The inner part is judged by its outermost vertices along the eight diagonals of
/// space: each must be where the outer part's winding number is not 0, or on the outer part, and
/// not all of them on it. Decides exactly if positions are about 1. `part_of` gives the part of
/// each face, or kNone; `shells` describes the parts.
///
/// There may be as many pairs as the square of the parts. Returns nothing if finding them would
/// take more than about a second.
std::optional<std::vector<Enclosure>> find_enclosures(const Polygons& faces,
                                                      std::span<const Vec3> positions,
                                                      std::span<const Index> part_of,
                                                      std::span<const Shell> shells);

}  // namespace kdm
