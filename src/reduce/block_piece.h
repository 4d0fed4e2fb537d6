// SPDX-License-Identifier: MIT
// The part of a workpiece in a block of space, reduced by itself.
#pragma once

#include <functional>

#include "mesh/marks.h"
#include "reduce/collapser.h"
#include "reduce/half_edges.h"
#include "reduce/space_blocks.h"
#include "reduce/workpiece.h"

namespace kdm {

/// A copy of the triangles that reach into a block. Those with all corners in the box are its own:
/// steps change these only, so what other blocks do is never in the way.
class BlockPiece {
 public:
  /// Copies from a workpiece that keeps a distance and has no groups, and from what is known of it.
  /// None of the block's triangles may have been removed. Several blocks may be copied at a time.
  BlockPiece(const Workpiece& whole, const CollapseState& state, const SpaceBlock& block);

  /// Flips false creases. No edge may be known to have failed.
  void flip();
  /// Collapses edges as long as some fit. Calls `between` from time to time with the number of
  /// triangles that are gone by then.
  void collapse(const std::function<void(Index gone)>& between);

  /// Takes the result over into the workpiece and the state, but for the workpiece's guard and its
  /// number of triangles. Several blocks may be put back at a time, once all have been reduced.
  void put_back(Workpiece& whole, CollapseState& state) const;

  Index collapses() const { return collapses_; }
  Index flips() const { return flips_; }
  /// Returns how many triangles are gone.
  Index gone() const { return piece_.mesh.triangles() - piece_.mesh.living_triangles(); }

 private:
  PartNumbers numbers_;
  Marks inside_;  // per vertex: is in the box
  Marks owned_;   // per triangle: all its corners are, or were
  Workpiece piece_;
  CollapseState state_;
  Index collapses_ = 0;
  Index flips_ = 0;
};

}  // namespace kdm
