// SPDX-License-Identifier: MIT
// Tells inside from outside for surfaces that are not closed, or whose triangles do not face
// consistently, and wherever else a field says what is inside.
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "grid/splitting_edges.h"
#include "inside/inside_model.h"
#include "inside/point_field.h"
#include "inside/resolve_segment.h"

namespace kdm {

/// Tells inside (state 1) from outside (0) by a field, such as the generalised winding number, and
/// makes hits that agree with this. The crossings of such a surface may contradict each other, so
/// states are not found by counting crossings. Where the surface has a hole, hits are invented.
class WindingOracle final : public InsideModel {
 public:
  /// Keeps a reference to the surface. `tolerance` is in lattice units.
  WindingOracle(const Surface& surface, std::shared_ptr<const PointField> field, double tolerance);

  /// Returns 1 if the grid vertex is inside, else 0. Vertices on the root cell's sides are outside.
  /// Answers are remembered.
  int state_at(const LatticePoint& vertex, int counted) override;

  /// Classifies crossings as far as that is possible before the splits of other cells bring more
  /// grid vertices onto the edge. Invents no crossings; `finish_edges` does.
  void plan_edge(const GridEdge& edge, std::vector<Crossing>& found,
                 std::vector<ClassifiedCrossing>& planned) override;

  /// Writes hits that fit the states of all grid vertices.
  void finish_edges(const EdgeCrossings& planned, HitWriter& writer) override;

  bool must_split(const LatticeBox& box) const override { return field_->must_split(box); }
  std::size_t work() const override { return field_->work() + joined_work_; }
  void report(GridStats& stats) const override { stats.winding_threshold = field_->threshold(); }
  std::unique_ptr<InsideModel> fork() const override;
  void join(InsideModel& fork) override;

 private:
  struct GridVertices;
  struct EdgeHit;

  WindingOracle(const WindingOracle& other, std::shared_ptr<const PointField> field);

  std::unique_ptr<WindingOracle> fork_oracle() const;
  template <typename Ask>
  void share(std::size_t count, const Ask& ask);
  bool find_state(const LatticePoint& vertex) const;
  GridVertices find_vertices(const GridData& grid, const std::vector<LatticeBox>& boxes);
  void finish_edge(const SplittingEdge& edge, const GridVertices& vertices,
                   std::span<const ClassifiedCrossing> planned, std::vector<EdgeHit>& hits);
  void finish_segment(const Segment& segment, std::vector<EdgeHit>& hits);
  Plane invented_plane(const Segment& segment, const ClassifiedCrossing& invented) const;

  const Surface& surface_;
  std::shared_ptr<const PointField> field_;
  SegmentResolver resolver_;
  std::size_t work_before_ = 0;                           // of the field that a fork was made of
  std::size_t joined_work_ = 0;                           // of forks
  std::unordered_map<std::uint64_t, bool> known_states_;  // by position; only ever looked up
  std::vector<Crossing> crossings_;                       // of the segment at hand
  std::vector<ClassifiedCrossing> classified_;            // of the segment at hand
};

}  // namespace kdm
