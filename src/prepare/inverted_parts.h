// SPDX-License-Identifier: MIT
// Finds closed parts of a mesh that are inside out.
#pragma once

#include <span>
#include <vector>

#include "mesh/marks.h"
#include "mesh/numbers.h"
#include "mesh/topology.h"

namespace kdm {

/// The closed parts of a mesh that must be turned.
struct InvertedParts {
  Marks must_turn;            ///< their triangles; empty if there is no such part
  Index parts = 0;            ///< how many parts must be turned
  bool all = false;           ///< every part that encloses a volume must be turned
  bool nesting_known = true;  ///< false if too many parts overlap to find which lie in which; then
                              ///< none is turned
};

/// Finds the closed parts that are inside out. Triangles belong to one part if sides of theirs are
/// opposite to each other; a part is closed if all its sides have opposites. Parts that are open or
/// enclose no volume are never turned.
///
/// Where every closed part has a positive volume, none is turned; to find this out takes linear
/// time. Otherwise parts are looked at from the outermost inwards. A part that lies in others is
/// first turned along with the smallest of these. Then the number of containing parts that look
/// outwards, less those that look inwards, tells whether there is material round the part. If so,
/// it stays: it is a cavity, or it bounds what is solid already. If not, it comes to look outwards,
/// unless it shares edges with others and nearly all of its faces have the solid of the whole
/// behind them as they are.
InvertedParts find_inverted_parts(std::span<const Triangle> triangles,
                                  const std::vector<Vec3>& points, const Topology& topology);

}  // namespace kdm
