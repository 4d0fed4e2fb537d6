// SPDX-License-Identifier: MIT
// Follows the winding numbers of several solids up one edge.
#include "inside/solids_model.h"

#include <algorithm>

#include "geometry/assert.h"
#include "inside/gaps.h"
#include "inside/winding.h"
#include "inside/write_hits.h"
#include "threads/share_work.h"

namespace kdm {
namespace {

class SolidsModel : public InsideModel {
 public:
  SolidsModel(const Surface& surface, SolidStates& states, double tolerance)
      : surface_(surface), states_(states), gaps_(surface, tolerance, true) {}
  // The same model with other states, which must hold those of that one.
  SolidsModel(const SolidsModel& other, SolidStates& states)
      : surface_(other.surface_), states_(states), gaps_(other.gaps_) {}

  std::optional<bool> is_inside(int state) const override { return states_.is_inside(state); }

  int state_after(int state, TriangleId triangle, bool leaving) override {
    return states_.after(state, surface_.solid_of[triangle], leaving);
  }

  void keep_relevant(int state, Marks& solids) override { states_.keep_relevant(state, solids); }

  int state_at(const LatticePoint& vertex, int counted) override {
    static_cast<void>(vertex);
    return counted;
  }

  // Where the faces of some solids were left out of a cell, their winding numbers differ from one
  // path to the next: only whether the ends are inside is certain.
  void plan_edge(const GridEdge& edge, std::vector<Crossing>& found,
                 std::vector<ClassifiedCrossing>& planned) override {
    sort_crossings(found);
    const std::size_t before = planned.size();
    int state = edge.state_low;
    for (std::size_t first = 0; first < found.size();) {
      std::size_t last = first + 1;
      while (last < found.size() && found[last].position == found[first].position) ++last;
      state = classify({found.data() + first, last - first}, state, planned);
      first = last;
    }
    gaps_.close(edge.axis, std::span(planned).subspan(before));
    KDM_ASSERT(states_.is_inside(state) == states_.is_inside(edge.state_high),
               "inside and outside agree along all edges of a splitting face");
  }

  void finish_edges(const EdgeCrossings& planned, HitWriter& writer) override {
    write_hits(planned, writer);
  }

  std::unique_ptr<InsideModel> fork() const override;

 private:
  class Fork;

  // Classifies crossings at one position, and returns the state above them. Taken together they
  // either bound the solid or not.
  int classify(std::span<const Crossing> found, int below,
               std::vector<ClassifiedCrossing>& planned) {
    int above = below;
    for (const Crossing& c : found) above = state_after(above, c.triangle, c.leaving);
    const bool was_inside = states_.is_inside(below);
    const bool changes = was_inside != states_.is_inside(above);
    const std::size_t keep = changes ? decisive(found, below, above) : found.size();
    // Solids merely touch where each is entered and left again at once.
    const CrossingRole others = found.size() > 1 && !was_inside && above == below
                                    ? CrossingRole::kTouching
                                    : CrossingRole::kInner;
    for (std::size_t i = 0; i < found.size(); ++i) {
      planned.emplace_back(found[i].position, found[i].triangle, above,
                           i == keep ? CrossingRole::kBounds : others, was_inside);
    }
    return above;
  }

  // Returns the crossing that stands for all: the first that matters, by itself or last of all, and
  // leaves its solid where the result is left; without such a one, the first that matters.
  // Triangles that matter are in the lists of all cells round the edge.
  std::size_t decisive(std::span<const Crossing> found, int below, int above) {
    const bool was_inside = states_.is_inside(below);
    std::size_t best = 0;
    int most = -1;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const Crossing& c = found[i];
      const bool matters =
          states_.is_inside(state_after(below, c.triangle, c.leaving)) != was_inside ||
          states_.is_inside(state_after(above, c.triangle, !c.leaving)) == was_inside;
      const int worth = (matters ? 2 : 0) + (c.leaving == was_inside ? 1 : 0);
      if (worth > most) best = i;
      most = std::max(most, worth);
    }
    return best;
  }

  const Surface& surface_;
  SolidStates& states_;
  GapRule gaps_;
};

// One with states of its own. Those that are known so far keep their numbers.
class SolidsModel::Fork final : public SolidsModel {
 public:
  explicit Fork(const SolidsModel& model)
      : Fork(model, std::make_unique<SolidStates>(model.states_)) {}

 private:
  Fork(const SolidsModel& model, std::unique_ptr<SolidStates> states)
      : SolidsModel(model, *states), own_states_(std::move(states)) {}

  std::unique_ptr<SolidStates> own_states_;
};

std::unique_ptr<InsideModel> SolidsModel::fork() const {
  return kHasThreads ? std::make_unique<Fork>(*this) : nullptr;
}

}  // namespace

std::unique_ptr<InsideModel> make_solids_model(const Surface& surface, SolidStates& states,
                                               double tolerance) {
  return std::make_unique<SolidsModel>(surface, states, tolerance);
}

}  // namespace kdm
