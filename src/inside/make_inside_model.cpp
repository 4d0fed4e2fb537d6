// SPDX-License-Identifier: MIT
// Implements the two models that count crossings, one for solids (by winding
// numbers) and one for sheets, and chooses among all models.
#include "inside/make_inside_model.h"

#include "geometry/assert.h"
#include "inside/gaps.h"
#include "inside/winding.h"
#include "inside/winding_field.h"
#include "inside/winding_oracle.h"
#include "inside/write_hits.h"
#include "threads/share_work.h"

namespace kdm {
namespace {

// A solid bounded by a closed, consistently oriented surface, which may overlap
// itself.
class WindingModel final : public InsideModel {
 public:
  WindingModel(const Surface& surface, InsideRule rule, double tolerance)
      : rule_(rule),
        gaps_(surface, tolerance, rule == InsideRule::kPositive || rule == InsideRule::kRepair) {}

  std::optional<bool> is_inside(int state) const override { return kdm::is_inside(rule_, state); }

  bool only_counts() const override { return true; }

  bool leaves_slivers_out() const override { return gaps_.leaves_slivers_out(); }

  int state_at(const LatticePoint& vertex, int counted) override {
    static_cast<void>(vertex);
    return counted;
  }

  void plan_edge(const GridEdge& edge, std::vector<Crossing>& found,
                 std::vector<ClassifiedCrossing>& planned) override {
    const std::size_t before = planned.size();
    const int state = classify_crossings(found, edge.state_low, rule_, planned);
    gaps_.close(edge.axis, std::span(planned).subspan(before));
    KDM_ASSERT(state == edge.state_high,
               "winding numbers agree along all edges of a splitting face");
    static_cast<void>(state);
  }

  void finish_edges(const EdgeCrossings& planned, HitWriter& writer) override {
    write_hits(planned, writer);
  }

  std::unique_ptr<InsideModel> fork() const override {
    return kHasThreads ? std::make_unique<WindingModel>(*this) : nullptr;
  }

 private:
  InsideRule rule_;
  GapRule gaps_;
};

// A surface that bounds no solid: every crossing is a hit, and there is only
// one state.
class SheetModel final : public InsideModel {
 public:
  bool only_counts() const override { return true; }

  int state_at(const LatticePoint& vertex, int counted) override {
    static_cast<void>(vertex);
    return counted;
  }

  void plan_edge(const GridEdge& edge, std::vector<Crossing>& found,
                 std::vector<ClassifiedCrossing>& planned) override {
    sort_crossings(found);
    for (const Crossing& c : found) {
      planned.emplace_back(c.position, c.triangle, edge.state_low, CrossingRole::kBounds,
                           c.leaving);
    }
  }

  void finish_edges(const EdgeCrossings& planned, HitWriter& writer) override {
    write_hits(planned, writer);
  }

  std::unique_ptr<InsideModel> fork() const override { return std::make_unique<SheetModel>(*this); }
};

}  // namespace

std::unique_ptr<InsideModel> make_inside_model(const Surface& surface, const BuildOptions& options,
                                               double tolerance) {
  if (surface.sheet) return std::make_unique<SheetModel>();
  if (surface.repair) {
    return std::make_unique<WindingOracle>(
        surface,
        std::make_shared<WindingField>(surface.triangles, options.winding_threshold, tolerance),
        tolerance);
  }
  return std::make_unique<WindingModel>(surface, options.inside, tolerance);
}

}  // namespace kdm
