// SPDX-License-Identifier: MIT
// The adaptive rule, which goes beyond paper 5.1.2: it splits a cell until the surface in it is met
// within the tolerance (fit_check.h) and keeps its topology (topology_check.h), each time where it
// helps most (cut_choice.h).
//
// Order. The fit comes first, for what fits often has the right topology. Among small parts it is
// the other way round: a cut that brings out a part's topology often makes it fit as well, and
// small parts are separated from each other before any of them is cut.
// Crossing shells. Where shells cross, their pieces bound the solid together: one vertex must fit
// them all, as it does on the crease of their union. Topology is claimed where the pieces cross
// along arcs (crossing_arcs.h), and pursued above the topology floor where they cross more often.
// Sheets. Where sheets cross, each keeps its own vertices.
// Holes. What closes a hole takes part in neither test.
#include <algorithm>
#include <cmath>

#include "inside/gaps.h"
#include "mesh/marks.h"
#include "split/contact_points.h"
#include "split/crossing_arcs.h"
#include "split/crossing_triangles.h"
#include "split/cut_choice.h"
#include "split/fit_check.h"
#include "split/inner_triangles.h"
#include "split/part_cuts.h"
#include "split/split_rules.h"
#include "split/topology_check.h"

namespace kdm {
namespace {

// Rounding moves the surface by less than a lattice unit; nothing finer than this can be asked for.
constexpr double kFinestTolerance = 2.0;
// Pieces that touch in a point are parted in cells of half the tolerance.
constexpr double kFine = 0.5;
// The budget of splits for the topology of what is thinner than the topology floor.
constexpr std::size_t kFineSplits = 200000;
constexpr std::size_t kFineSplitsPerTriangle = 16;
// Above this many triangles a cell is split on a clear misfit even where shells may hide others.
constexpr std::size_t kManyTriangles = 64;
// For a rule that goes by a tolerance: cells at no depth are small enough by that alone.
constexpr int kNoLastDepth = -1;
// So many centres of unresolved leaves are kept; an even number.
constexpr std::size_t kMostPositions = 1000;

double diagonal(const LatticeBox& box) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double side = extent(box, i);
    sum += side * side;
  }
  return std::sqrt(sum);
}

// Returns how many splits the topology below the floor may take. A tolerance wider than the whole
// surface asks for nothing of it.
std::size_t budget_of_fine_splits(const Surface& surface, double tolerance) {
  if (tolerance * surface.lattice.step > surface.extent) return 0;
  return kFineSplits + kFineSplitsPerTriangle * surface.triangles.size();
}

// Where solids cross, the crease between them is met more closely than the rest: it is a curve, so
// that costs little, and where it bends or ends there are no thin chips.
double shared_tolerance(const Surface& surface, double tolerance) {
  constexpr double kCreaseShare = 0.25;
  if (!surface.several_solids()) return tolerance;
  return std::max(kCreaseShare * tolerance, kFinestTolerance);
}

class AdaptiveRule : public SplitRule {
 public:
  AdaptiveRule(const Surface& surface, InsideModel& model, double tolerance, int max_depth,
               CutPosition position)
      : surface_(surface),
        counts_states_(model.is_inside(0).has_value()),
        open_surface_(has_open_sides(surface)),
        tolerance_(std::max(tolerance, kFinestTolerance)),
        last_depth_(tolerance > 0 ? kNoLastDepth : max_depth),
        position_(position),
        parts_(surface),
        surface_in_cell_(surface),
        fit_(surface, tolerance_, shared_tolerance(surface, tolerance_)),
        topology_(surface),
        contact_points_(surface),
        states_(model),
        inner_triangles_(surface, model, states_, widest_gap(tolerance)),
        arcs_(states_),
        cuts_(surface, tolerance_, max_depth, position),
        most_fine_splits_(budget_of_fine_splits(surface, tolerance)) {}

  std::optional<Split> choose(const CellView& cell) override {
    std::optional<Split> split = choose_split(cell);
    if (split && position_ != CutPosition::kInTurn) split->value = off_gaps(cell, *split);
    return split;
  }

  bool is_local() const override { return has_budget(0); }
  Tally tally() const override { return {unresolved_leaves_, fine_splits_}; }
  bool has_budget(std::size_t fine_splits) const override {
    return fine_splits_ + fine_splits < most_fine_splits_;
  }
  void count_cells(std::size_t fine_splits, std::span<const Vec3> unresolved) override {
    fine_splits_ += fine_splits;
    for (const Vec3& centre : unresolved) count_unresolved(centre);
  }

  void report(GridStats& stats) const override {
    stats.unresolved_leaves = unresolved_leaves_;
    stats.unresolved_positions = unresolved_;
    stats.topology_resolved = unresolved_leaves_ == 0;
  }

 private:
  std::optional<Split> choose_split(const CellView& cell) {
    // An octree's cell is cut in eight, by three splits, or not at all.
    if (position_ == CutPosition::kInTurn && cell.depth % 3 != 0) return split_for_fit(cell);
    CellCrossings& crossings = surface_in_cell_.crossings;
    crossings.collect(cell);
    fit_.plan_hits(cell.box, crossings);
    // Whatever lies in a cell smaller than the tolerance is met. Where no tolerance is asked for,
    // cells at the greatest depth are as small as was asked for.
    const bool small = diagonal(cell.box) <= tolerance_ || cell.depth == last_depth_;
    const bool topology_first = find_small_parts(cell);
    if (!small && !topology_first && is_clear_misfit(cell)) return split_for_fit(cell);
    surface_in_cell_.find_pieces(cell.box, cell.entries);
    if (surface_in_cell_.triangles.empty()) return std::nullopt;
    return choose_by_pieces(cell, small, topology_first);
  }

  // Tells whether topology comes first in the cell, and looks for a plane between its parts. Where
  // many small parts have no plane between them, topology does not come first: each part would be
  // cut to its end before the next.
  bool find_small_parts(const CellView& cell) {
    between_parts_.reset();
    if (position_ == CutPosition::kInTurn || open_surface_ || !parts_.all_small(cell.entries)) {
      return false;
    }
    between_parts_ = parts_.propose(cell.entries);
    return between_parts_ || !parts_.has_many_parts(cell.entries);
  }

  // Where crossings drop out some of the surface may lie within other shells and need not be met;
  // then the cell is looked at more closely, unless that takes too long.
  bool is_clear_misfit(const CellView& cell) {
    const CellCrossings& crossings = surface_in_cell_.crossings;
    const bool all_kept = !crossings.all.empty() && !crossings.some_dropped();
    return (all_kept || cell.entries.size() > kManyTriangles) &&
           fit_.is_clear_misfit(cell.box, cell.entries, crossings);
  }

  std::optional<Split> choose_by_pieces(const CellView& cell, bool small, bool topology_first) {
    const bool some_cross = surface_in_cell_.crossings.some_dropped() && leave_inner_out(cell);
    // Where pieces touch on an edge of the cell, or a gap between them is closed there, loops lead
    // from one to the other; and so may what closes two pieces that end in the cell.
    const CellCrossings& crossings = surface_in_cell_.crossings;
    const bool shells_cross = some_cross || crossings.has_touches || crossings.has_gaps ||
                              (surface_.repair && surface_in_cell_.several_pieces_have_rims());
    const LeafVertices vertices =
        shells_cross ? LeafVertices::kOneForAll : LeafVertices::kOneEachPiece;
    std::optional<TopologyFault> fault;
    if (topology_first) {
      fault = topology_.find_fault(surface_in_cell_);
      if (fault && !cuts_.is_below_topology_floor(surface_in_cell_)) {
        return split_for_topology(cell, *fault, shells_cross);
      }
    }
    if (!small && !fit_.pieces_fit(surface_in_cell_, vertices)) return split_for_fit(cell);
    if (!topology_first) fault = topology_.find_fault(surface_in_cell_);
    if (fault) return split_for_topology(cell, *fault, shells_cross);
    if (surface_.sheet) return std::nullopt;
    if (counts_states_ && !is_fine(cell.box) &&
        contact_points_.exist_in(surface_in_cell_, shells_cross)) {
      return split_for_fit(cell);
    }
    if (shells_cross) {
      const bool plain = some_cross && !crossings.has_touches && !crossings.has_gaps;
      return plain ? choose_at_crossings(cell, small) : leave_unresolved(cell);
    }
    if (crossings.some_dropped()) return std::nullopt;
    if (topology_.is_surely_embedded(surface_in_cell_) || !triangles_cross()) return std::nullopt;
    // Shells cross between the cell's edges, so that no crossing was dropped.
    const bool fits = small || fit_.pieces_fit(surface_in_cell_, LeafVertices::kOneForAll);
    return fits ? leave_unresolved(cell) : split_for_fit(cell);
  }

  // Finds pieces and triangles that bound nothing in a cell with crossings that are no hits. A
  // piece that crosses no other one bounds the solid all over or nowhere, as its crossings say; of
  // the others, each triangle is looked at. Returns whether pieces that bound the solid cross or
  // touch.
  bool leave_inner_out(const CellView& cell) {
    CellPieces& pieces = surface_in_cell_.pieces;
    states_known_ = false;
    const Marks& crossing = crossing_triangles_.find_all(surface_in_cell_.triangles);
    const bool some_cross = crossing.any();
    if (!counts_states_) {
      // Only where all crossings say so, for they may contradict each other.
      const std::span<const Piece> all = pieces.all();
      if (!std::all_of(all.begin(), all.end(), [](const Piece& p) { return p.seems_inner(); })) {
        return some_cross;
      }
    } else if (some_cross && surface_in_cell_.triangles.size() <= kManyTriangles) {
      states_.start(surface_in_cell_.triangles, cell.state);
      inner_triangles_.find(surface_in_cell_, crossing);
      states_known_ = true;
    } else if (some_cross) {
      // Too many to be looked at: any of what crosses may bound the solid.
      surface_in_cell_.inner.assign(surface_in_cell_.triangles.size(), {});
    }
    must_bound_.assign(pieces.all().size());
    for (MemberId m = 0; counts_states_ && m < surface_in_cell_.triangles.size(); ++m) {
      if (crossing.test(m) && !surface_in_cell_.is_inner(m)) must_bound_.set(pieces.piece_of(m));
    }
    for (PieceId i = 0; i < pieces.all().size(); ++i) {
      if (pieces.all()[i].seems_inner() && !must_bound_.test(i)) pieces.set_inner(i);
    }
    pieces.leave_inner_out(surface_in_cell_.triangles);
    for (MemberId m = 0; m < surface_in_cell_.triangles.size(); ++m) {
      if (crossing.test(m) && !pieces.all()[pieces.piece_of(m)].is_inner) return true;
    }
    return false;
  }

  // Tells whether vertices in the cell may be parted within it, and stay within the tolerance.
  bool is_fine(const LatticeBox& box) const { return diagonal(box) <= kFine * tolerance_; }

  bool triangles_cross() { return crossing_triangles_.exist_in(surface_in_cell_.triangles); }

  // Where pieces cross, and fit: the cell stays a leaf, resolved if the solid's boundary is known
  // to be a set of disks.
  std::optional<Split> choose_at_crossings(const CellView& cell, bool small) {
    if (!states_known_ || surface_.patched) return leave_unresolved(cell);
    const CrossingArcs::Answer answer = arcs_.join_pieces_to_disks(
        surface_in_cell_, crossing_triangles_.find_pairs(surface_in_cell_.triangles));
    if (answer == CrossingArcs::Answer::kDisks) return std::nullopt;
    const bool pursue = answer == CrossingArcs::Answer::kTooMuch && !small &&
                        !surface_.has_rims() && !cuts_.is_below_topology_floor(surface_in_cell_);
    const std::optional<Split> split = pursue ? cuts_.split_for_fit(cell) : std::nullopt;
    return split ? split : leave_unresolved(cell);
  }

  std::optional<Split> split_for_fit(const CellView& cell) {
    const std::optional<Split> split = cuts_.split_for_fit(cell);
    return split ? split : leave_unresolved(cell);
  }

  // Below the floor, topology is pursued where the surface is embedded, within the budget, and not
  // where some of it is invented.
  std::optional<Split> split_for_topology(const CellView& cell, const TopologyFault& fault,
                                          bool shells_cross) {
    std::optional<Split> split;
    if (!cuts_.is_below_topology_floor(surface_in_cell_)) {
      split = cuts_.split_for_topology(cell, surface_in_cell_, fault, between_parts_,
                                       TopologyFloor::kAtTolerance);
    } else if (has_budget(0) && !shells_cross && !surface_.has_rims() && !surface_.patched &&
               !triangles_cross()) {
      ++fine_splits_;
      split = cuts_.split_for_topology(cell, surface_in_cell_, fault, between_parts_,
                                       TopologyFloor::kAtLattice);
    }
    return split ? split : leave_unresolved(cell);
  }

  // Makes the cell a leaf although it does not pass the tests.
  std::optional<Split> leave_unresolved(const CellView& cell) {
    count_unresolved(centre_of(cell.box));
    return std::nullopt;
  }

  void count_unresolved(const Vec3& centre) {
    if (unresolved_leaves_ % stride_ == 0) keep_position(centre);
    ++unresolved_leaves_;
  }

  // Keeps the centre of a leaf. Of too many, every second stays, and so do every second of those to
  // come.
  void keep_position(const Vec3& centre) {
    if (unresolved_.size() == kMostPositions) {
      for (std::size_t i = 0; 2 * i < kMostPositions; ++i) unresolved_[i] = unresolved_[2 * i];
      unresolved_.resize(kMostPositions / 2);
      stride_ *= 2;
    }
    unresolved_.push_back(centre);
  }

  const Surface& surface_;
  bool counts_states_;
  bool open_surface_;
  double tolerance_;
  int last_depth_;  // of cells whose surface need not be met within the tolerance
  CutPosition position_;
  PartCuts parts_;
  CellSurface surface_in_cell_;
  FitCheck fit_;
  TopologyCheck topology_;
  CrossingTriangles crossing_triangles_;
  ContactPoints contact_points_;
  CellStates states_;
  bool states_known_ = false;  // in the cell at hand
  InnerTriangles inner_triangles_;
  CrossingArcs arcs_;
  Marks must_bound_;  // per piece of the cell at hand: some triangle is known to bound the solid
  CutChoice cuts_;
  std::optional<Split> between_parts_;  // a plane between the small parts of the cell at hand
  Index unresolved_leaves_ = 0;
  std::size_t most_fine_splits_;  // below the topology floor
  std::size_t fine_splits_ = 0;
  Index stride_ = 1;              // of so many unresolved leaves the centre of one is kept
  std::vector<Vec3> unresolved_;  // lattice coordinates
};

}  // namespace

std::unique_ptr<SplitRule> make_adaptive_rule(const Surface& surface, InsideModel& model,
                                              double tolerance, int depth, CutPosition position) {
  return std::make_unique<AdaptiveRule>(surface, model, tolerance, depth, position);
}

}  // namespace kdm
