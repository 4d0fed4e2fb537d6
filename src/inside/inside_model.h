// SPDX-License-Identifier: MIT
// What counts as inside: the interface through which construction asks, whatever the answer rests
// on.
//
// Every grid vertex has a state, an `int` that only the model understands. With winding numbers it
// is the winding number itself. Boolean operations will number the combinations of winding numbers,
// one of each operand, that they come across, and use these numbers as states; then only the two
// functions `state_after` and `is_inside` (inside/winding.h) have to change. States must depend on
// the place alone, so that cells agree on them however they are split.
#pragma once

#include <vector>

#include "inside/crossing.h"
#include "inside/hit_writer.h"
#include "kdmanifold/grid.h"

namespace kdm {

/// A grid edge between two grid vertices whose states are known.
struct GridEdge {
  int axis;           ///< along which it runs
  LatticePoint low;   ///< its lower end
  std::int32_t high;  ///< coordinate of its upper end along the axis
  int state_low;
  int state_high;
};

/// Decides which crossings bound the solid. The root cell's corners are outside: state 0.
class InsideModel {
 public:
  virtual ~InsideModel() = default;

  /// Returns the state of a grid vertex. `counted` is the state that the crossings between the
  /// vertex and another one, on the same grid line, lead to; it is returned unless the model has
  /// other means.
  virtual int state_at(const LatticePoint& vertex, int counted) = 0;

  /// Sorts the crossings that were found on an edge and appends them, classified, to `planned`.
  /// They ascend along the edge.
  virtual void plan_edge(const GridEdge& edge, std::vector<Crossing>& found,
                         std::vector<ClassifiedCrossing>& planned) = 0;

  /// Writes the hits of all splitting edges when all cells are made. `planned` holds what
  /// `plan_edge` appended for them.
  virtual void finish_edges(const EdgeCrossings& planned, HitWriter& writer) = 0;

  /// Returns how much was computed so far to find states, in units of WindingField::work; 0 if
  /// states are only counted.
  virtual std::size_t work() const { return 0; }

  /// Notes in the statistics what the model chose by itself.
  virtual void report(GridStats& stats) const { static_cast<void>(stats); }
};

}  // namespace kdm
