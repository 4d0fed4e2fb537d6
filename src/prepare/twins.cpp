// SPDX-License-Identifier: MIT
#include "prepare/twins.h"

#include "mesh/marks.h"
#include "mesh/sides.h"

namespace kdm {

std::vector<TriangleId> find_possible_twins(const Topology& topology) {
  const std::vector<SideId>& opposite = topology.opposite;
  Marks shared(opposite.size());
  for (const SideId side : topology.non_manifold_sides) shared.set(side);
  std::vector<TriangleId> found;
  for (TriangleId t = 0; 3 * std::size_t{t} < opposite.size(); ++t) {
    TriangleId twin = kNone;  // the only one that it may be
    bool possible = true;
    for (SideId side = 3 * t; side < 3 * t + 3 && possible; ++side) {
      if (opposite[side] == kNone || shared.test(side)) continue;
      const TriangleId beyond = triangle_of(opposite[side]);
      possible = twin == kNone || twin == beyond;
      twin = beyond;
    }
    if (possible) found.push_back(t);
  }
  return found;
}

}  // namespace kdm
