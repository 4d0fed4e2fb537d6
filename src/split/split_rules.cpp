// SPDX-License-Identifier: MIT
// The uniform rule, which looks at the depth of a cell only, and the median rule, which looks at
// the number of its triangles (paper 5.1.2 (1)).
#include "split/split_rules.h"

#include <algorithm>

#include "mesh/marks.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

/// Splits all cells above the greatest depth in the middle, across x, y and z in turn.
class UniformRule : public SplitRule {
 public:
  explicit UniformRule(int max_depth) : max_depth_(max_depth) {}

  std::optional<Split> choose(const CellView& cell) override {
    return cell.depth < max_depth_ ? midpoint_in_turn(cell.box, cell.depth) : std::nullopt;
  }

 private:
  int max_depth_;
};

/// Splits cells at the median of their triangles' centres until grid edges cross all triangles of a
/// cell (paper 5.1.2 (1)). A triangle counts as one of the cell that holds its centre; triangles
/// without area count nowhere. The rule's range for a cell is a range of `centres_`.
class MedianRule : public SplitRule {
 public:
  MedianRule(const Surface& surface, int max_depth)
      : max_depth_(max_depth), crossed_(surface.triangles.size()) {
    centres_.reserve(surface.triangles.size());
    for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
      if (surface.degenerate.test(i)) continue;
      const LatticeTriangle& t = surface.triangles[i];
      Centre centre{{}, static_cast<TriangleId>(i)};
      for (int k = 0; k < 3; ++k) centre.point[k] = (t[0][k] + t[1][k] + t[2][k]) / 3;
      centres_.push_back(centre);
    }
  }

  RuleRange root() override { return {0, static_cast<Index>(centres_.size())}; }

  std::optional<Split> choose(const CellView& cell) override {
    if (cell.depth >= max_depth_) return std::nullopt;
    const auto begin = centres_.begin() + cell.range.begin;
    const auto end = centres_.begin() + cell.range.end;
    if (std::all_of(begin, end, [&](const Centre& c) { return crossed_.test(c.triangle); })) {
      return std::nullopt;
    }
    // The axes along which the centres spread furthest come first; among equal ones, the axes
    // along which the box is longest.
    LatticeBox spread{begin->point, begin->point};
    for (auto i = begin; i != end; ++i) {
      for (int k = 0; k < 3; ++k) {
        spread.lo[k] = std::min(spread.lo[k], i->point[k]);
        spread.hi[k] = std::max(spread.hi[k], i->point[k]);
      }
    }
    std::array<int, 3> axes{0, 1, 2};
    sort_by(axes, [&](int a, int b) {
      const auto key = [&](int k) {
        return std::array<std::int32_t, 3>{spread.hi[k] - spread.lo[k],
                                           cell.box.hi[k] - cell.box.lo[k], -k};
      };
      return key(a) > key(b);
    });
    for (const int axis : axes) {
      const auto middle = begin + (end - begin - 1) / 2;
      std::nth_element(begin, middle, end, [axis](const Centre& a, const Centre& b) {
        return a.point[axis] != b.point[axis] ? a.point[axis] < b.point[axis]
                                              : a.triangle < b.triangle;
      });
      const std::int32_t value = middle->point[axis];
      if (value > cell.box.lo[axis] && value < cell.box.hi[axis]) return Split{axis, value};
    }
    return std::nullopt;
  }

  std::array<RuleRange, 2> divide(RuleRange range, const Split& split) override {
    const auto begin = centres_.begin() + range.begin;
    const auto end = centres_.begin() + range.end;
    const auto cut = std::partition(
        begin, end, [&](const Centre& c) { return below_plane(c.point[split.axis], split.value); });
    const auto middle = static_cast<Index>(cut - centres_.begin());
    return {RuleRange{range.begin, middle}, RuleRange{middle, range.end}};
  }

  void on_crossing(TriangleId triangle) override { crossed_.set(triangle); }

 private:
  struct Centre {
    LatticePoint point;
    TriangleId triangle;
  };

  int max_depth_;
  std::vector<Centre> centres_;  // the centres of each cell are consecutive
  Marks crossed_;                // per triangle: a grid edge crosses it
};

}  // namespace

std::optional<Split> midpoint_in_turn(const LatticeBox& box, int depth) {
  const int axis = depth % 3;
  const std::int32_t value = box.lo[axis] + (box.hi[axis] - box.lo[axis]) / 2;
  if (value == box.lo[axis]) return std::nullopt;
  return Split{axis, value};
}

std::int32_t off_gaps(const CellView& cell, const Split& split) {
  constexpr int kTries = 4;
  std::int32_t value = split.value;
  for (int i = 0; i < kTries; ++i) {
    const std::int32_t before = value;
    for (int e = 4 * split.axis; e < 4 * split.axis + 4; ++e) {
      const EdgeRange edge = cell.edges[e];
      for (Index c = edge.begin; c + 1 < edge.end; ++c) {
        if (!begins_gap(cell.crossings[c])) continue;
        const std::int32_t low = floor_of(cell.crossings[c].position());
        const Index other = end_of_gap(cell.crossings, c);
        const std::int32_t high = floor_of(cell.crossings[other].position()) + 1;
        // A crossing lies above the plane of its floor.
        if (value > low && value < high) value = value - low < high - value ? low : high;
      }
    }
    if (value == before) break;
  }
  const bool fits = value > cell.box.lo[split.axis] && value < cell.box.hi[split.axis];
  return fits ? value : split.value;
}

std::unique_ptr<SplitRule> make_split_rule(const Surface& surface, InsideModel& model,
                                           const BuildOptions& options, double tolerance,
                                           int depth) {
  switch (options.strategy) {
    case SplitStrategy::kUniform:
      return std::make_unique<UniformRule>(depth);
    case SplitStrategy::kMedian:
      return std::make_unique<MedianRule>(surface, depth);
    case SplitStrategy::kOctree:
      return make_adaptive_rule(surface, model, tolerance, depth, CutPosition::kInTurn);
    case SplitStrategy::kFeature:
      return make_adaptive_rule(surface, model, tolerance, depth, CutPosition::kFeature);
    case SplitStrategy::kAdaptive:
      return make_adaptive_rule(surface, model, tolerance, depth, CutPosition::kHalving);
  }
  return nullptr;
}

}  // namespace kdm
