// SPDX-License-Identifier: MIT
#include "reduce/collapse_blocks.h"

#include <array>
#include <atomic>
#include <memory>
#include <vector>

#include "mesh/boxes.h"
#include "reduce/block_piece.h"
#include "reduce/space_blocks.h"
#include "threads/share_work.h"

namespace kdm {
namespace {

// A block has this many triangles at most where space can be cut so. With fewer, more is left to do
// between blocks, in turn; with more, a block's triangles leave the caches.
constexpr Index kMostInBlock = 4096;

std::vector<Box> boxes_of(const Workpiece& piece) {
  std::vector<Box> out(piece.mesh.triangles());
  for (TriangleId t = 0; t < out.size(); ++t) {
    if (piece.mesh.is_removed(t)) continue;
    const Triangle c = piece.mesh.corners(t);
    out[t] = box_of(piece.positions[c[0]], piece.positions[c[1]], piece.positions[c[2]]);
  }
  return out;
}

// Cut at other places, what lay between blocks is within them.
constexpr int kRounds = 2;
constexpr std::array<double, kRounds> kBelow = {1.0 / 2, 1.0 / 3};

}  // namespace

bool is_worth_blocks(const Workpiece& piece) {
  return piece.distance && piece.groups.empty() && piece.mesh.living_triangles() > 2 * kMostInBlock;
}

BlockSteps collapse_in_blocks(Workpiece& piece, CollapseState& state,
                              const std::function<void(Index)>& report) {
  BlockSteps out;
  std::atomic<Index> gone = 0;
  for (int round = 0; round < kRounds && is_worth_blocks(piece); ++round) {
    const std::vector<SpaceBlock> blocks = cut_space(boxes_of(piece), kMostInBlock, kBelow[round]);
    std::vector<std::unique_ptr<BlockPiece>> pieces(blocks.size());
    share_work(blocks.size(), workers(), [&](std::size_t task, int worker) {
      Index before = 0;
      const auto between = [&](Index now) {
        gone += now - before;
        before = now;
        if (worker == 0) report(gone);
      };
      pieces[task] = std::make_unique<BlockPiece>(piece, state, blocks[task]);
      if (round == 0) pieces[task]->flip();
      pieces[task]->collapse(between);
      between(pieces[task]->gone());
    });
    share_work(pieces.size(), workers(),
               [&](std::size_t task, int) { pieces[task]->put_back(piece, state); });
    for (const std::unique_ptr<BlockPiece>& one : pieces) {
      piece.mesh.count_removed(one->gone());
      out.collapses += one->collapses();
      out.flips += one->flips();
    }
  }
  if (piece.guard) piece.guard.emplace(piece.mesh, piece.positions);
  return out;
}

}  // namespace kdm
