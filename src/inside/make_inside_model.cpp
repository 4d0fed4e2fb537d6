// SPDX-License-Identifier: MIT
// Implements the two models that count crossings, one for solids (by winding numbers) and one for
// sheets, and chooses among all models.
#include "inside/make_inside_model.h"

#include "geometry/assert.h"
#include "grid/splitting_edges.h"
#include "inside/winding.h"
#include "inside/winding_oracle.h"

namespace kdm {
namespace {

// Makes a hit of every crossing that was planned to be kept.
void write_kept(const EdgeCrossings& planned, HitWriter& writer) {
  const std::vector<LatticeBox> boxes = cell_boxes(writer.grid());
  for_each_splitting_edge(writer.grid(), boxes, [&](const SplittingEdge& edge) {
    for (const ClassifiedCrossing& crossing : planned.of(edge.number)) {
      if (crossing.kept()) writer.add(edge, crossing);
    }
    writer.end_edge(edge);
  });
}

// A solid bounded by a closed, consistently oriented surface, which may overlap itself.
class WindingModel final : public InsideModel {
 public:
  explicit WindingModel(InsideRule rule) : rule_(rule) {}

  int state_at(const LatticePoint& vertex, int counted) override {
    static_cast<void>(vertex);
    return counted;
  }

  void plan_edge(const GridEdge& edge, std::vector<Crossing>& found,
                 std::vector<ClassifiedCrossing>& planned) override {
    const int state = classify_crossings(found, edge.state_low, rule_, planned);
    KDM_ASSERT(state == edge.state_high,
               "winding numbers agree along all edges of a splitting face");
    static_cast<void>(state);
  }

  void finish_edges(const EdgeCrossings& planned, HitWriter& writer) override {
    write_kept(planned, writer);
  }

 private:
  InsideRule rule_;
};

// A surface that bounds no solid: every crossing is a hit, and there is only one state.
class SheetModel final : public InsideModel {
 public:
  int state_at(const LatticePoint& vertex, int counted) override {
    static_cast<void>(vertex);
    return counted;
  }

  void plan_edge(const GridEdge& edge, std::vector<Crossing>& found,
                 std::vector<ClassifiedCrossing>& planned) override {
    sort_crossings(found);
    for (const Crossing& c : found) {
      planned.emplace_back(c.position, c.triangle, edge.state_low, true, c.leaving);
    }
  }

  void finish_edges(const EdgeCrossings& planned, HitWriter& writer) override {
    write_kept(planned, writer);
  }
};

}  // namespace

std::unique_ptr<InsideModel> make_inside_model(const Surface& surface, const BuildOptions& options,
                                               double tolerance) {
  if (surface.sheet) return std::make_unique<SheetModel>();
  if (surface.repair) {
    return std::make_unique<WindingOracle>(surface, options.winding_threshold, tolerance);
  }
  return std::make_unique<WindingModel>(options.inside);
}

}  // namespace kdm
