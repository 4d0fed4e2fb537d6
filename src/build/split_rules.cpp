// SPDX-License-Identifier: MIT
// The split rules that look at depth or triangle counts only: uniform, median (paper 5.1.2 (1)).
#include "build/split_rules.h"

#include <algorithm>

namespace kdm {
namespace {

class UniformRule : public SplitRule {
 public:
  explicit UniformRule(int depth) : depth_(depth) {}

  std::optional<Split> choose(const CellView& cell) override {
    return cell.depth < depth_ ? midpoint_in_turn(cell.box, cell.depth) : std::nullopt;
  }

 private:
  int depth_;
};

/// Paper 5.1.2 (1): a triangle belongs to the cell that holds its centre; cells are cut at the
/// median of their triangles' centres until a grid edge has met each of them.
class MedianRule : public SplitRule {
 public:
  MedianRule(const Surface& surface, int depth) : depth_(depth) {
    met_.assign(surface.triangles.size(), 0);
    centres_.reserve(surface.triangles.size());
    for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
      const LatticeTriangle& t = surface.triangles[i];
      LatticePoint centre{};
      for (int k = 0; k < 3; ++k) centre[k] = (t[0][k] + t[1][k] + t[2][k]) / 3;
      centres_.push_back(centre);
      if (surface.degenerate[i] == 0) order_.push_back(static_cast<Index>(i));
    }
  }

  RuleRange root() override { return {0, static_cast<Index>(order_.size())}; }

  std::optional<Split> choose(const CellView& cell) override {
    if (cell.depth >= depth_) return std::nullopt;
    const LatticeBox& box = cell.box;
    const auto begin = order_.begin() + cell.range.begin;
    const auto end = order_.begin() + cell.range.end;
    if (std::all_of(begin, end, [&](Index t) { return met_[t] != 0; })) return std::nullopt;
    // Axes in order of the spread of the centres, then of the box.
    LatticeBox spread{centres_[*begin], centres_[*begin]};
    for (auto i = begin; i != end; ++i) {
      for (int k = 0; k < 3; ++k) {
        spread.lo[k] = std::min(spread.lo[k], centres_[*i][k]);
        spread.hi[k] = std::max(spread.hi[k], centres_[*i][k]);
      }
    }
    std::array<int, 3> axes{0, 1, 2};
    std::sort(axes.begin(), axes.end(), [&](int a, int b) {
      const auto key = [&](int k) {
        return std::array<std::int32_t, 3>{spread.hi[k] - spread.lo[k], box.hi[k] - box.lo[k], -k};
      };
      return key(a) > key(b);
    });
    for (const int axis : axes) {
      const auto middle = begin + (end - begin) / 2;
      std::nth_element(begin, middle, end, [&](Index a, Index b) {
        return std::pair(centres_[a][axis], a) < std::pair(centres_[b][axis], b);
      });
      const std::int32_t value = centres_[*middle][axis];
      if (value > box.lo[axis] && value < box.hi[axis]) return Split{axis, value};
    }
    return std::nullopt;
  }

  std::array<RuleRange, 2> divide(RuleRange range, const Split& split) override {
    const auto begin = order_.begin() + range.begin;
    const auto end = order_.begin() + range.end;
    const auto cut =
        std::partition(begin, end, [&](Index t) { return centres_[t][split.axis] < split.value; });
    const auto middle = static_cast<Index>(cut - order_.begin());
    return {RuleRange{range.begin, middle}, RuleRange{middle, range.end}};
  }

  void on_crossing(Index triangle) override { met_[triangle] = 1; }

 private:
  int depth_;
  std::vector<LatticePoint> centres_;
  std::vector<Index> order_;
  std::vector<char> met_;
};

}  // namespace

std::optional<Split> midpoint_in_turn(const LatticeBox& box, int depth) {
  const int axis = depth % 3;
  const std::int32_t value = box.lo[axis] + (box.hi[axis] - box.lo[axis]) / 2;
  if (value == box.lo[axis]) return std::nullopt;
  return Split{axis, value};
}

std::unique_ptr<SplitRule> make_split_rule(const Surface& surface, const BuildOptions& options,
                                           double tolerance, int depth) {
  switch (options.strategy) {
    case SplitStrategy::kUniform:
      return std::make_unique<UniformRule>(depth);
    case SplitStrategy::kMedian:
      return std::make_unique<MedianRule>(surface, depth);
    case SplitStrategy::kOctree:
      return make_adaptive_rule(surface, tolerance, depth, true);
    case SplitStrategy::kAdaptive:
      return make_adaptive_rule(surface, tolerance, depth, false);
  }
  return nullptr;
}

}  // namespace kdm
