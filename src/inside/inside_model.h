// SPDX-License-Identifier: MIT
// Defines the interface through which construction asks what lies inside the solid.
//
// Every grid vertex has a state, an `int` that only the model understands. With winding numbers it
// is the winding number itself. Boolean operations will have a winding number for each operand at
// every point; they will number the combinations that occur and use these numbers as states. Then
// only the two functions `state_after` and `is_inside` (inside/winding.h) have to change. The state
// must depend on the position of the vertex alone, so that all cells with the vertex agree on it.
#pragma once

#include <optional>
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

  /// Returns the state of a grid vertex. `counted` is the state that follows from the state of
  /// another vertex on the same grid line by counting the crossings between the two; a model that
  /// counts returns it, other models may ignore it.
  virtual int state_at(const LatticePoint& vertex, int counted) = 0;

  /// Tells whether points of this state are inside, where states are winding numbers that may be
  /// counted along any path: `state_after` (inside/winding.h) says how they change from one side of
  /// a triangle to the other. Other models return nothing.
  virtual std::optional<bool> is_inside(int state) const {
    static_cast<void>(state);
    return std::nullopt;
  }

  /// Sorts the crossings `found` on an edge by their position, classifies them, and appends them to
  /// `planned` in ascending order.
  virtual void plan_edge(const GridEdge& edge, std::vector<Crossing>& found,
                         std::vector<ClassifiedCrossing>& planned) = 0;

  /// Writes the hits of all splitting edges. To be called when all cells are made. `planned` holds
  /// for each edge what `plan_edge` appended.
  virtual void finish_edges(const EdgeCrossings& planned, HitWriter& writer) = 0;

  /// Returns how much was computed so far to find states, in units of WindingField::work; 0 if
  /// states are only counted.
  virtual std::size_t work() const { return 0; }

  /// Writes to the statistics what the model chose itself, such as a winding threshold.
  virtual void report(GridStats& stats) const { static_cast<void>(stats); }
};

}  // namespace kdm
