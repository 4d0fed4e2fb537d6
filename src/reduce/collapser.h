// SPDX-License-Identifier: MIT
// Collapses edges of a mesh, the cheapest first, as long as the result stays manifold, meets itself
// nowhere and stays near to the reference.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "mesh/marks.h"
#include "reduce/collapse_queue.h"
#include "reduce/error_quadric.h"
#include "reduce/kept_lines.h"
#include "reduce/smooth_test.h"
#include "reduce/workpiece.h"

namespace kdm {

/// The loop over the edges.
class Collapser {
 public:
  explicit Collapser(Workpiece& piece);

  /// Goes on until `triangles` are left, or no edge can be collapsed any more. Calls `between` from
  /// time to time.
  void collapse_to(Index triangles, const std::function<void()>& between);

  Index collapses() const { return collapses_; }

 private:
  enum class Verdict { kDone, kNoPlace, kNever };

  void add_quadrics();
  void add_line_quadrics();
  void consider(SideId edge);
  void push(SideId edge, CollapsePlace place);
  Vec3 point_of(SideId edge, CollapsePlace place, const ErrorQuadric& sum) const;
  ErrorQuadric quadric_of(SideId edge) const;
  double limit_of(SideId edge) const;
  Verdict try_step(SideId edge, CollapsePlace place);
  bool meets_link_condition(SideId edge);
  void make_ring(SideId edge, const Vec3& point);
  bool keeps_shape() const;
  bool is_guarded() const;
  bool is_folded() const;
  void step(SideId edge);
  void retry_edges_at(VertexId v);
  bool is_flat(SideId edge) const;
  bool retry_waiting_edges();

  Workpiece& piece_;
  std::optional<SmoothTest> smooth_;  // if a distance is kept
  KeptLines lines_;
  std::vector<ErrorQuadric> quadric_;  // per vertex, relative to centre_
  Vec3 centre_;
  CollapseQueue queue_;
  std::vector<Index> version_;         // per half-edge
  Marks failed_;                       // per half-edge: no place for its vertex was found
  Marks waiting_;                      // per half-edge: is one of `waiting_edges_`
  std::vector<SideId> waiting_edges_;  // they failed, and their surroundings have changed since
  std::vector<Index> seen_;            // per vertex: the last stamp it got
  Index stamp_ = 0;
  CollapseRing ring_;
  Index collapses_ = 0;
};

}  // namespace kdm
