// SPDX-License-Identifier: MIT
// Defines the levels to which a hit and its loops can be refined so that their triangles do not
// meet other triangles.
//
// At the highest levels a hit has six triangles, each of which lies in one leaf and so cannot meet
// triangles in other leaves. That takes many triangles, so only hits whose triangles cross others
// are raised, by one level at a time.
#pragma once

#include <cstdint>
#include <vector>

#include "extract/dual/dual_mesh.h"

namespace kdm {

/// What is done to a hit and its loops; each level includes what is done at those before it.
enum class EmbedLevel : std::uint8_t {
  kTriangle,     ///< the hit is the triangle of its three loops
  kHitVertices,  ///< the hit and its links become vertices; its loops' vertices are not split
  kOffSides,     ///< the loops' vertices lie off the sides of their leaves
  kLinksApart,   ///< the links' vertices lie where the links of one face keep clear of each other
  kCentred,      ///< the loops' vertices lie amid their hits, so that loops of a leaf keep clear
  kNested        ///< of loops only: all loops of the leaf are nested in it (extract/embed)
};

/// The level of each hit and each loop; both lists are empty where all are triangles.
struct EmbedLevels {
  std::vector<EmbedLevel> hits;
  std::vector<EmbedLevel> loops;
  double margin = 0;  ///< of links' vertices to the sides of their faces at least; lattice units
  const DualMesh* plain = nullptr;  ///< the mesh before anything was refined; null where all are
                                    ///< triangles

  EmbedLevel of_hit(HitId hit) const { return hits.empty() ? EmbedLevel::kTriangle : hits[hit]; }
  EmbedLevel of_loop(LoopId loop) const {
    return loops.empty() ? EmbedLevel::kTriangle : loops[loop];
  }
};

}  // namespace kdm
