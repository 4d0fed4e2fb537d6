// SPDX-License-Identifier: MIT
// Finds the holes of a surface: closed rounds of sides that have no opposite.
#pragma once

#include <span>
#include <vector>

#include "mesh/numbers.h"

namespace kdm {

/// A closed round of triangle sides without opposite. It passes each of its points once.
struct Hole {
  std::vector<SideId> sides;  ///< each starts where the one before ends; at least three
};

/// Finds the holes of a surface. Every side without opposite is part of one hole, except for two
/// sides along one edge that run against each other: these close each other. A round that passes a
/// point several times is cut there into several holes. Takes linear time. `points` is above all
/// corner numbers.
std::vector<Hole> find_holes(std::span<const Triangle> triangles, Index points,
                             std::span<const SideId> opposite);

}  // namespace kdm
