// SPDX-License-Identifier: MIT
// The top-down construction of the cell tree and its hits (paper 5.1.1).
//
// A cell goes down with its twelve edges, each a range of crossings on one ancestor's splitting
// edge, and with the winding numbers at its corners; so a new corner's winding number is looked
// up in a range, never searched for among triangles.
#include "construct/construct.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/assert.h"
#include "inside/repair.h"
#include "inside/winding.h"
#include "mesh/progress.h"
#include "split/split_rules.h"
#include "split/triangle_lists.h"

namespace kdm {
namespace {

constexpr std::uint32_t kProgressInterval = 4096;  // cells between two calls

// Surfaces to be repaired may cross and end everywhere, where no tolerance is met and winding
// numbers take a while. These limits are beyond what any takes that means something; past them, the
// whole surface is met less closely.
constexpr std::size_t kSplits = 300000;
constexpr std::size_t kSplitsATriangle = 32;
constexpr std::size_t kWork = 40000000;  // as WindingField counts
constexpr std::size_t kWorkATriangle = 64;

/// What a cell hands down. Corners are numbered by bits: 1 for x, 2 for y, 4 for z at the high end.
struct CellFrame {
  Index cell = 0;
  int depth = 0;
  LatticeBox box;
  CellEdges edges;
  std::array<int, 8> winding{};
  ListRange triangles;
  RuleRange rule;
  double done_before = 0;  // fraction of the work before and after this cell
  double done_after = 1;
};

class Construction {
 public:
  Construction(Surface& surface, const BuildOptions& options, double tolerance, int depth,
               Repair* repair, const Progress& progress, GridData& grid)
      : surface_(surface),
        inside_(options.inside),
        repair_(repair),
        progress_(progress),
        grid_(grid),
        rule_(make_split_rule(surface, options, tolerance, depth)),
        lists_(surface.triangles) {
    if (repair_ == nullptr) return;
    splits_left_ = kSplits + kSplitsATriangle * surface.triangles.size();
    most_work_ = repair_->work() + kWork + kWorkATriangle * surface.triangles.size();
  }

  /// The fraction of the work that was done before a limit was met; 1: all.
  double run() {
    grid_.hits.clear();
    grid_.stats = {};
    grid_.cells.assign(1, Cell());
    grid_.edge_begin.assign(1, 0);
    const std::size_t guess = 2 * surface_.triangles.size();
    grid_.cells.reserve(2 * guess);
    grid_.edge_begin.reserve(4 * guess);
    grid_.hits.reserve(2 * guess);
    winding_after_.reserve(2 * guess);
    CellFrame root;
    root.triangles = lists_.all();
    root.rule = rule_->root();
    split_cell(root);
    if (splits_left_ == 0) return done_;
    rule_->report(grid_.stats);
    if (repair_ != nullptr) {
      grid_.stats.winding_threshold = repair_->threshold();
      repair_->resolve(grid_);
    } else {
      drop_internal_crossings();
    }
    grid_.cells.shrink_to_fit();
    grid_.edge_begin.shrink_to_fit();
    grid_.hits.shrink_to_fit();
    mark_active_sides(grid_);
    return 1;
  }

 private:
  void split_cell(const CellFrame& frame) {
    if (is_beyond_limits(frame)) return;
    count_cell(frame.done_before);
    grid_.stats.depth = std::max(grid_.stats.depth, frame.depth);
    if (frame.triangles.size() == 0) return;
    const std::optional<Split> split =
        rule_->choose({frame.box, frame.depth, lists_.entries(frame.triangles), frame.rule,
                       frame.edges, grid_.hits, kept_});
    if (!split) return;
    --splits_left_;
    KDM_ASSERT(split->value > frame.box.lo[split->axis] && split->value < frame.box.hi[split->axis],
               "a split lies strictly inside its cell");
    const auto first_child = static_cast<Index>(grid_.cells.size());
    grid_.cells[frame.cell] = Cell(first_child, split->axis, split->value);
    grid_.cells.resize(grid_.cells.size() + 2);

    CellFrame below = frame;
    CellFrame above = frame;
    divide_edges(frame, *split, below, above);
    const TriangleLists::Children lists = lists_.divide(frame.triangles, split->axis, split->value);
    add_splitting_edges(frame, *split, below, above);

    below.triangles = lists.below;
    above.triangles = lists.above;
    const auto ranges = rule_->divide(frame.rule, *split);
    below.rule = ranges[0];
    above.rule = ranges[1];
    below.cell = first_child;
    above.cell = first_child + 1;
    below.depth = above.depth = frame.depth + 1;
    below.box.hi[split->axis] = split->value;
    above.box.lo[split->axis] = split->value;
    const double share = lists.below.size() + lists.above.size();
    below.done_after = above.done_before =
        frame.done_before +
        (frame.done_after - frame.done_before) * (share > 0 ? lists.below.size() / share : 0.5);
    // The list of the upper child lies on top in the arena, but the lower child comes first in
    // depth-first order; its descendants' lists go above both.
    split_cell(below);
    split_cell(above);
    lists_.release(lists.below);
  }

  bool is_beyond_limits(const CellFrame& frame) {
    if (splits_left_ > 0 && (repair_ == nullptr || repair_->work() < most_work_)) return false;
    splits_left_ = 0;
    done_ = std::min(done_, frame.done_before);
    return true;
  }

  // The four edges across the plane are cut; their crossings there give the winding numbers at
  // the corners of the splitting face.
  void divide_edges(const CellFrame& frame, const Split& split, CellFrame& below,
                    CellFrame& above) {
    const int w = split.axis;
    for (int e = 0; e < 4; ++e) {
      const bool high_next = (e & 1) != 0;
      const bool high_previous = (e & 2) != 0;
      const EdgeRange whole = frame.edges[4 * w + e];
      Index cut = whole.begin;
      while (cut < whole.end && floor_of(grid_.hits[cut].position) < split.value) ++cut;
      below.edges[4 * w + e].end = cut;
      above.edges[4 * w + e].begin = cut;
      const int low_corner =
          (high_next ? 1 << next_axis(w) : 0) | (high_previous ? 1 << previous_axis(w) : 0);
      const int high_corner = low_corner | 1 << w;
      int winding = cut == whole.begin ? frame.winding[low_corner] : winding_after_[cut - 1];
      if (repair_ != nullptr) {
        const LatticePoint corner =
            corner_on_plane(frame.box, w, split.value, high_next, high_previous);
        winding = repair_->inside(corner) ? 1 : 0;
      }
      below.winding[high_corner] = winding;
      above.winding[low_corner] = winding;
    }
  }

  // Finds the crossings of the four new edges and hands them to both children.
  void add_splitting_edges(const CellFrame& frame, const Split& split, CellFrame& below,
                           CellFrame& above) {
    const int w = split.axis;
    const int u = next_axis(w);
    const int v = previous_axis(w);
    const LatticeBox& box = frame.box;
    for (std::vector<Crossing>& crossings : crossings_) crossings.clear();
    for (const Index i : lists_.straddlers()) {
      const ListEntry& entry = lists_.entry(i);
      if (entry.lo[v] == box.lo[v]) cross(entry.triangle, u, box.lo[v], split.value, box, 0);
      if (entry.hi[u] == box.hi[u]) cross(entry.triangle, v, split.value, box.hi[u], box, 1);
      if (entry.hi[v] == box.hi[v]) cross(entry.triangle, u, box.hi[v], split.value, box, 2);
      if (entry.lo[u] == box.lo[u]) cross(entry.triangle, v, split.value, box.lo[u], box, 3);
    }
    // The corner at the low end of each edge, on the splitting face.
    const std::array<int, 4> low_corner{0, 1 << u, 1 << v, 0};
    for (int i = 0; i < 4; ++i) {
      EdgeRange range;
      range.begin = static_cast<Index>(grid_.hits.size());
      const int from = above.winding[low_corner[i]];
      const int to = above.winding[low_corner[i] | 1 << axis_of_edge(w, i)];
      if (repair_ != nullptr) {
        plan_edge(box, split, i, from != 0, to != 0);
      } else {
        const int winding = walk_edge(crossings_[i], from, inside_, walked_);
        KDM_ASSERT(surface_.sheet || winding == to,
                   "winding numbers agree along all edges of a splitting face");
        static_cast<void>(winding);
      }
      for (const WalkedCrossing& c : walked_) {
        grid_.hits.push_back(Hit(c.crossing.position, c.crossing.triangle, c.leaving,
                                 reversed_on_edge(i, c.leaving)));
        winding_after_.push_back(c.winding_after);
        kept_.push_back(c.kept ? 1 : 0);
        dropped_ += c.kept ? 0 : 1;
        rule_->on_crossing(c.crossing.triangle);
      }
      range.end = static_cast<Index>(grid_.hits.size());
      grid_.edge_begin.push_back(range.end);
      // Edges 0 and 2 run along u, at the low and high end of v; 1 and 3 along v, at the high and
      // low end of u. For axis u the next axis is v and the previous one is w.
      const int axis = axis_of_edge(w, i);
      const bool high = i == 1 || i == 2;
      if (axis == u) {
        below.edges[cell_edge(u, high, true)] = range;
        above.edges[cell_edge(u, high, false)] = range;
      } else {
        below.edges[cell_edge(v, true, high)] = range;
        above.edges[cell_edge(v, false, high)] = range;
      }
    }
  }

  void plan_edge(const LatticeBox& box, const Split& split, int i, bool inside_low,
                 bool inside_high) {
    const int axis = axis_of_edge(split.axis, i);
    const LatticePoint low = corner_on_plane(box, split.axis, split.value, i == 1, i == 2);
    repair_->plan_edge({axis, low, box.hi[axis], inside_low, inside_high}, crossings_[i], walked_);
  }

  // Adds the crossing of a triangle with splitting edge i if there is one within the cell.
  void cross(Index triangle, int axis, std::int32_t p, std::int32_t q, const LatticeBox& box,
             int i) {
    const LatticeTriangle& t = surface_.triangles[triangle];
    const int sign = line_crosses(t, axis, p, q);
    if (sign == 0) return;
    const LinePosition position = crossing_position(t, axis, p, q);
    if (floor_of(position) < box.lo[axis] || floor_of(position) >= box.hi[axis]) return;
    crossings_[i].push_back({position, triangle, sign > 0});
  }

  // Crossings at which the inside rule does not change were needed for winding numbers only.
  void drop_internal_crossings() {
    if (dropped_ == 0) return;
    Index kept = 0;
    Index i = 0;
    for (std::size_t edge = 1; edge < grid_.edge_begin.size(); ++edge) {
      for (; i < grid_.edge_begin[edge]; ++i) {
        if (kept_[i] != 0) grid_.hits[kept++] = grid_.hits[i];
      }
      grid_.edge_begin[edge] = kept;
    }
    grid_.hits.resize(kept);
  }

  void count_cell(double fraction) {
    if (++cells_since_report_ < kProgressInterval) return;
    cells_since_report_ = 0;
    report_progress(progress_, fraction, "build");
  }

  Surface& surface_;
  InsideRule inside_;
  Repair* repair_;
  const Progress& progress_;
  GridData& grid_;
  std::unique_ptr<SplitRule> rule_;
  TriangleLists lists_;
  std::vector<int> winding_after_;  // per crossing; hits_ holds all crossings until the end
  std::vector<char> kept_;
  Index dropped_ = 0;
  std::array<std::vector<Crossing>, 4> crossings_;
  std::vector<WalkedCrossing> walked_;
  std::uint32_t cells_since_report_ = 0;
  std::size_t splits_left_ = std::numeric_limits<std::size_t>::max();
  std::size_t most_work_ = 0;
  double done_ = 1;  // when a limit was met
};

// How much wider a tolerance must be for all to be within the limits of which this fraction was.
// Where triangles cross everywhere, it grows with about the power 2/3 of the tolerance's inverse.
double widening_for(double done) {
  const double part = std::max(done, 1e-3);
  return std::clamp(1 / (part * std::sqrt(part)), 1.5, 16.0);
}

}  // namespace

double construct_cells(Surface& surface, const BuildOptions& options, double tolerance, int depth,
                       const Progress& progress, GridData& grid) {
  double shown = 0;
  Progress onwards;
  if (progress) {
    onwards = [&](double fraction, std::string_view phase) {
      shown = std::max(shown, fraction);  // another attempt starts where the last one stopped
      return progress(shown, phase);
    };
  }
  std::optional<Repair> repair;
  if (surface.repair) repair.emplace(surface, options.winding_threshold, tolerance);
  for (;;) {
    Construction construction(surface, options, tolerance, depth, repair ? &*repair : nullptr,
                              onwards, grid);
    const double done = construction.run();
    if (done == 1) return tolerance;
    tolerance = widening_for(done) * std::max(tolerance, 1.0);
  }
}

}  // namespace kdm
