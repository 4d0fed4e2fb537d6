// SPDX-License-Identifier: MIT
// Collapses edges of a mesh, the cheapest first, as long as the result stays manifold, meets itself
// nowhere and stays near to the reference.
#pragma once

#include <functional>
#include <vector>

#include "mesh/marks.h"
#include "reduce/collapse_queue.h"
#include "reduce/collapse_test.h"
#include "reduce/edge_errors.h"
#include "reduce/kept_lines.h"
#include "reduce/workpiece.h"

namespace kdm {

/// What a loop over the edges knows, for another one that goes on after it.
struct CollapseState {
  VertexQuadrics quadrics;
  Marks failed;  ///< per half-edge: no place for its vertex was found
};

/// Returns what is known before the first edge is collapsed.
CollapseState first_state(const Workpiece& piece);

/// The loop over the edges.
class Collapser {
 public:
  /// Begins where others stopped.
  Collapser(Workpiece& piece, CollapseState state);

  /// Goes on until `triangles` are left, or no edge can be collapsed any more. Calls `between` from
  /// time to time.
  void collapse_to(Index triangles, const std::function<void()>& between);

  Index collapses() const { return collapses_; }
  /// Returns what is known once no edge can be collapsed any more.
  CollapseState state() const { return {errors_.quadrics(), failed_}; }

 private:
  void consider(SideId edge);
  void push(SideId edge, CollapsePlace place);
  double limit_of(SideId edge) const;
  bool is_current(const Candidate& candidate) const {
    return candidate.version == version_[candidate.edge] && piece_.mesh.is_edge(candidate.edge);
  }
  void step(SideId edge, const CollapseTrial& trial);
  void retry_edges_at(VertexId v);
  bool is_flat(SideId edge) const;
  bool retry_waiting_edges();

  Workpiece& piece_;
  KeptLines lines_;
  EdgeErrors errors_;
  CollapseQueue queue_;
  std::vector<Index> version_;         // per half-edge
  Marks failed_;                       // per half-edge: no place for its vertex was found
  Marks waiting_;                      // per half-edge: is one of `waiting_edges_`
  std::vector<SideId> waiting_edges_;  // they failed, and their surroundings have changed since
  CollapseTest test_;
  CollapseTrial trial_;
  Index collapses_ = 0;
};

}  // namespace kdm
