// SPDX-License-Identifier: MIT
// Turns crossings into the hits of the grid; nothing else writes hits when a grid is built.
#pragma once

#include <vector>

#include "grid/grid_data.h"
#include "grid/splitting_edges.h"
#include "inside/crossing.h"
#include "prepare/surface.h"

namespace kdm {

/// Writes the hits of a grid whose cells are complete, one splitting edge after the other in the
/// order of their numbers. Also writes the planes that the hits have: numbered in the order of
/// their first hits, and turned so that their normals point out of the solid. A triangle that
/// bounds the solid from both sides yields two planes; one without hits yields none.
class HitWriter {
 public:
  /// Leaves every splitting edge of `grid` without hits. Both arguments must outlive the writer.
  /// Reserves memory for `expected_hits` hits; more may follow.
  HitWriter(const Surface& surface, std::size_t expected_hits, GridData& grid);

  /// Returns the grid. Its edges have no hits until they are written.
  const GridData& grid() const { return grid_; }

  /// Adds a hit of a triangle on an edge. Hits come edge by edge, ascending along each.
  void add(const EdgePlace& edge, const ClassifiedCrossing& crossing);
  /// Adds a hit that is not made by a triangle but invented to close a hole. The normal of its
  /// plane points out of the solid.
  void add_invented(const EdgePlace& edge, LinePosition position, bool leaving, const Plane& plane);
  /// Ends an edge. To be called for every edge, also for those without hits.
  void end_edge(const EdgePlace& edge) {
    grid_.edge_begin[edge.number + 1] = static_cast<HitId>(grid_.hits.size());
  }

  /// Releases memory that the grid does not need and returns the triangle of each hit, kNone for
  /// invented ones.
  std::vector<TriangleId> finish();

 private:
  PlaneId plane_of(TriangleId triangle, bool turned);

  const Surface& surface_;
  GridData& grid_;
  std::vector<PlaneId> plane_number_;  // per triangle two: of its plane as it is, and turned
  std::vector<TriangleId> triangle_of_hit_;
};

}  // namespace kdm
