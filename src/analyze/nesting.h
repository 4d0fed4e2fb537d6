// SPDX-License-Identifier: MIT
// Which closed parts of a mesh lie in which.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mesh/polygons.h"

namespace kdm {

/// What `find_enclosures` asks of a part.
struct Shell {
  Box bounds;
  bool closed = false;  ///< every edge used equally often in both directions
};

struct Enclosure {
  Index inner;
  Index outer;
};

/// Pairs of closed parts, ascending: the outermost vertices of the inner one along the eight
/// diagonals are where the outer one's winding number is not 0, or on it, but not all of them on
/// it. Exact for positions of about 1. `part_of` gives each face's part or kNone. There may be as
/// many pairs as the square of the parts: beyond a limit of work nothing is said.
std::optional<std::vector<Enclosure>> find_enclosures(const Polygons& faces,
                                                      std::span<const Vec3> positions,
                                                      std::span<const Index> part_of,
                                                      std::span<const Shell> shells);

}  // namespace kdm
