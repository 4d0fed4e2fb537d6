// SPDX-License-Identifier: MIT
// Defines the interface through which construction asks what lies inside the solid.
//
// Every grid vertex has a state, an `int` that only the model understands. With winding numbers it
// is the winding number itself; of several solids it stands for one winding number each
// (inside/solid_states.h). The state must depend on the position of the vertex alone, so that all
// cells with the vertex agree on it.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "inside/crossing.h"
#include "inside/hit_writer.h"
#include "kdmanifold/grid.h"
#include "mesh/marks.h"

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

  /// Tells whether points of this state are inside, where states may be counted along any path from
  /// one side of a triangle to the other. Other models return nothing.
  virtual std::optional<bool> is_inside(int state) const {
    static_cast<void>(state);
    return std::nullopt;
  }

  /// Tells whether states follow from the crossings on grid lines alone, one line as good as
  /// another, and those crossings become hits that `plan_edge` keeps, or at gaps that stay open.
  virtual bool only_counts() const { return false; }

  /// Returns the state beyond a triangle, for models that count: `leaving` says whether the way
  /// leads out of its front.
  virtual int state_after(int state, TriangleId triangle, bool leaving) {
    static_cast<void>(triangle);
    return state + (leaving ? -1 : 1);
  }

  /// Of several solids: given those with faces in a cell, and the state of one of the cell's
  /// corners, unmarks the solids whose faces bound nothing in it.
  virtual void keep_relevant(int state, Marks& solids) {
    static_cast<void>(state);
    static_cast<void>(solids);
  }

  /// Tells whether what is left of the solid between two faces on each other may be left out,
  /// though the states say that it is inside.
  virtual bool leaves_slivers_out() const { return false; }

  /// Sorts the crossings `found` on an edge by their position, classifies them, and appends them to
  /// `planned` in ascending order.
  virtual void plan_edge(const GridEdge& edge, std::vector<Crossing>& found,
                         std::vector<ClassifiedCrossing>& planned) = 0;

  /// Writes the hits of all splitting edges. To be called when all cells are made. `planned` holds
  /// for each edge what `plan_edge` appended.
  virtual void finish_edges(const EdgeCrossings& planned, HitWriter& writer) = 0;

  /// Tells whether what is inside changes within the box elsewhere than at the surface, so that a
  /// leaf must be smaller.
  virtual bool must_split(const LatticeBox& box) const {
    static_cast<void>(box);
    return false;
  }

  /// Returns how much was computed so far to find states, in units of WindingField::work; 0 if
  /// states are only counted.
  virtual std::size_t work() const { return 0; }

  /// Returns a model that gives the same answers, for another thread to ask. The states that this
  /// one knows by now mean the same there, and its work begins with that of this one. Null: only
  /// one thread may ask.
  virtual std::unique_ptr<InsideModel> fork() const { return nullptr; }
  /// Takes over from a fork what it found out, so that it need not be found again, and its work.
  virtual void join(InsideModel& fork) { static_cast<void>(fork); }

  /// Writes to the statistics what the model chose itself, such as a winding threshold.
  virtual void report(GridStats& stats) const { static_cast<void>(stats); }
};

}  // namespace kdm
