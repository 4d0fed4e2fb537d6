// SPDX-License-Identifier: MIT
// How much is done about a hit, so that its triangles meet no others: six triangles a hit, of which
// each lies in one leaf, cannot meet those of other leaves.
#pragma once

#include <cstdint>
#include <vector>

#include "extract/dual/dual_mesh.h"

namespace kdm {

/// What is done about a hit and its loops; each includes those before.
enum class Detail : std::uint8_t {
  kPlain,    ///< the triangle of three loops
  kFull,     ///< the hit and its links become vertices; its loops' vertices are not split
  kInside,   ///< the loops' vertices lie off the sides of their leaves
  kApart,    ///< the links' vertices lie where those of one face keep clear of each other
  kCentred,  ///< the loops' vertices lie amid their hits: several loops of a leaf keep clear
  kLayered   ///< of loops: they are drawn inwards, all of their leaf (extract/embed/layers.h)
};

/// Per hit and per loop; empty where all is plain.
struct Details {
  std::vector<Detail> hits;
  std::vector<Detail> loops;
  double margin = 0;  ///< least distance of links' vertices from the sides of their faces
  const DualMesh* plain = nullptr;  ///< what the mesh was made from; null where all is plain

  Detail of_hit(Index hit) const { return hits.empty() ? Detail::kPlain : hits[hit]; }
  Detail of_loop(Index loop) const { return loops.empty() ? Detail::kPlain : loops[loop]; }
};

}  // namespace kdm
