// SPDX-License-Identifier: MIT
// The split rules: midpoints to a fixed depth, midpoints until plane, medians (paper 5.1.2 (1)).
#include "build/split_rules.h"

#include <algorithm>
#include <numeric>

#include "geometry/predicates.h"

namespace kdm {
namespace {

// The middle of the box along the axis whose turn it is; nothing once that is one unit wide.
std::optional<Split> midpoint(const LatticeBox& box, int depth) {
  const int axis = depth % 3;
  const std::int32_t value = box.lo[axis] + (box.hi[axis] - box.lo[axis]) / 2;
  if (value == box.lo[axis]) return std::nullopt;
  return Split{axis, value};
}

class UniformRule : public SplitRule {
 public:
  explicit UniformRule(int depth) : depth_(depth) {}

  std::optional<Split> choose(const LatticeBox& box, int depth, std::span<const ListEntry>,
                              RuleRange) override {
    return depth < depth_ ? midpoint(box, depth) : std::nullopt;
  }

 private:
  int depth_;
};

/// A cell in which all triangles lie in one plane and face one way holds one plane section, which
/// its edges' hits describe without loss; any other cell is split down to the depth limit.
class OctreeRule : public SplitRule {
 public:
  OctreeRule(const Surface& surface, int depth) : surface_(surface), depth_(depth) {}

  std::optional<Split> choose(const LatticeBox& box, int depth, std::span<const ListEntry> entries,
                              RuleRange) override {
    if (depth >= depth_ || one_plane(entries)) return std::nullopt;
    return midpoint(box, depth);
  }

 private:
  bool one_plane(std::span<const ListEntry> entries) const {
    const LatticeTriangle& first = surface_.triangles[entries[0].triangle];
    const auto normal = area_vector(first);
    for (const ListEntry& entry : entries.subspan(1)) {
      const LatticeTriangle& t = surface_.triangles[entry.triangle];
      for (const LatticePoint& corner : t) {
        std::int64_t volume = 0;
        for (int i = 0; i < 3; ++i) volume += normal[i] * (corner[i] - first[0][i]);
        if (volume != 0) return false;
      }
      const auto other = area_vector(t);
      for (int i = 0; i < 3; ++i) {
        if ((normal[i] > 0) != (other[i] > 0) || (normal[i] < 0) != (other[i] < 0)) return false;
      }
    }
    return true;
  }

  const Surface& surface_;
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

  std::optional<Split> choose(const LatticeBox& box, int depth, std::span<const ListEntry>,
                              RuleRange range) override {
    if (depth >= depth_) return std::nullopt;
    const auto begin = order_.begin() + range.begin;
    const auto end = order_.begin() + range.end;
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

std::unique_ptr<SplitRule> make_split_rule(const Surface& surface, const BuildOptions& options) {
  switch (options.strategy) {
    case SplitStrategy::kUniform:
      return std::make_unique<UniformRule>(options.depth);
    case SplitStrategy::kOctree:
      return std::make_unique<OctreeRule>(surface, options.depth);
    case SplitStrategy::kMedian:
      return std::make_unique<MedianRule>(surface, options.depth);
  }
  return nullptr;
}

}  // namespace kdm
