// SPDX-License-Identifier: MIT
// Union-find in which each triangle knows whether it is turned against its representative. Edges
// whose triangles agree go first: they never contradict each other.
#include "prepare/neighbours.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "mesh/edge_sides.h"
#include "mesh/same_corners.h"

namespace kdm {
namespace {

class TurnedSets {
 public:
  explicit TurnedSets(std::size_t size) : parent_(size), against_(size, 0) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  /// Its representative, and whether it is turned against that.
  std::pair<Index, char> find(Index i) {
    Index root = i;
    char against = 0;
    while (parent_[root] != root) {
      against ^= against_[root];
      root = parent_[root];
    }
    for (char rest = against; parent_[i] != root && i != root;) {
      const Index next = parent_[i];
      const char step = against_[i];
      parent_[i] = root;
      against_[i] = rest;
      rest ^= step;
      i = next;
    }
    return {root, against};
  }

  /// Joins the sets of `a` and `b`; false if they are one already, in which this does not hold.
  bool join(Index a, Index b, char against) {
    const auto [root_a, against_a] = find(a);
    const auto [root_b, against_b] = find(b);
    const char between = against_a ^ against_b ^ against;
    if (root_a == root_b) return between == 0;
    parent_[std::max(root_a, root_b)] = std::min(root_a, root_b);
    against_[std::max(root_a, root_b)] = between;
    return true;
  }

 private:
  std::vector<Index> parent_;
  std::vector<char> against_;
};

// Two triangles that run the same way along their edge.
struct Disagreement {
  double length;  // of the edge, squared
  Index first;
  Index second;
  bool remains = false;  // whatever is turned
};

class NeighbourWalk {
 public:
  NeighbourWalk(std::span<const Triangle> triangles, const std::vector<Vec3>& points)
      : triangles_(triangles),
        points_(points),
        edges_(triangles, static_cast<Index>(points.size())),
        sets_(triangles.size()),
        trusted_(triangles.size(), 0) {
    result_.flip.assign(triangles.size(), 0);
    result_.part.assign(triangles.size(), kNone);
    result_.copy_of.assign(triangles.size(), kNone);
  }

  NeighbourDirections run() {
    find_trusted();
    find_copies();
    join_neighbours();
    join_trusted();
    number_parts();
    turn_lesser_areas();
    find_open_parts();
    return std::move(result_);
  }

 private:
  Index points() const { return static_cast<Index>(points_.size()); }
  bool is_copy(Index triangle) const { return result_.copy_of[triangle] != kNone; }

  // A component, joined by edges of any kind, in which no edge is used more often in one direction,
  // is closed and consistently oriented as it is, unless all of its faces lie back to back.
  void find_trusted() {
    TurnedSets components(triangles_.size());
    std::vector<Index> unbalanced;
    bool crowded = false;
    edges_.for_each_edge([&](Index, std::span<const EdgeSide> edge) {
      std::ptrdiff_t balance = 0;
      for (const EdgeSide& s : edge) {
        components.join(edge[0].side / 3, s.side / 3, 0);
        balance += s.forward ? 1 : -1;
      }
      crowded = crowded || edge.size() > 2;
      if (balance != 0) unbalanced.push_back(edge[0].side / 3);
    });
    if (!crowded) return;
    for_each_corner_set(triangles_, points(), [&](std::span<const SortedCorners> group) {
      std::ptrdiff_t balance = 0;
      for (const SortedCorners& s : group) balance += s.turned ? 1 : -1;
      if (balance != 0) trusted_[components.find(group[0].triangle).first] = 1;
    });
    for (const Index t : unbalanced) trusted_[components.find(t).first] = 0;
    for (Index t = 0; t < trusted_.size(); ++t) trusted_[t] = trusted_[components.find(t).first];
  }

  void find_copies() {
    for_each_corner_set(triangles_, points(), [&](std::span<const SortedCorners> group) {
      if (trusted_[group[0].triangle] != 0) return;
      for (const SortedCorners& other : group.subspan(1)) {
        result_.copy_of[other.triangle] = group[0].triangle;
        sets_.join(group[0].triangle, other.triangle, other.turned != group[0].turned);
      }
    });
  }

  void join_neighbours() {
    std::vector<EdgeSide> sides;
    edges_.for_each_edge([&](Index lower, std::span<const EdgeSide> edge) {
      sides.clear();
      for (const EdgeSide& s : edge) {
        if (!is_copy(s.side / 3)) sides.push_back(s);
      }
      if (sides.size() != 2) {
        others_.insert(others_.end(), sides.begin(), sides.end());
        others_end_.push_back(others_.size());
      } else if (sides[0].forward != sides[1].forward) {
        sets_.join(sides[0].side / 3, sides[1].side / 3, 0);
      } else {
        const double length = (points_[lower] - points_[sides[0].upper]).squaredNorm();
        disagreements_.push_back({length, sides[0].side / 3, sides[1].side / 3});
      }
    });
    std::sort(disagreements_.begin(), disagreements_.end(),
              [](const Disagreement& a, const Disagreement& b) {
                return a.length != b.length
                           ? a.length > b.length
                           : std::array{a.first, a.second} < std::array{b.first, b.second};
              });
    for (Disagreement& d : disagreements_) {
      d.remains = !sets_.join(d.first, d.second, 1);
      result_.contradictions += d.remains ? 1 : 0;
    }
  }

  // What closes only together with others stays with them.
  void join_trusted() {
    std::vector<char> is_open(triangles_.size(), 0);
    for_each_unbalanced([&](Index root) { is_open[root] = 1; });
    for (Index t = 0; t < triangles_.size(); ++t) is_open[t] = is_open[sets_.find(t).first];
    for_each_other([&](std::span<const EdgeSide> edge) {
      Index first = kNone;
      for (const EdgeSide& s : edge) {
        const Index t = s.side / 3;
        if (trusted_[t] == 0 || is_open[t] == 0) continue;
        if (first == kNone) first = t;
        sets_.join(first, t, 0);
      }
    });
  }

  template <typename Visit>
  void for_each_other(const Visit& visit) const {
    std::size_t begin = 0;
    for (const std::size_t end : others_end_) {
      visit(std::span<const EdgeSide>(others_.data() + begin, end - begin));
      begin = end;
    }
  }

  // Visits the sets that use an edge of one triangle, or of many, more often in one direction.
  template <typename Visit>
  void for_each_unbalanced(const Visit& visit) {
    std::vector<std::pair<Index, int>> uses;
    for_each_other([&](std::span<const EdgeSide> edge) {
      uses.clear();
      for (const EdgeSide& s : edge) {
        const auto [root, against] = sets_.find(s.side / 3);
        uses.emplace_back(root, s.forward != (against != 0) ? 1 : -1);
      }
      std::sort(uses.begin(), uses.end());
      for (auto first = uses.begin(); first != uses.end();) {
        std::ptrdiff_t balance = 0;
        auto last = first;
        for (; last != uses.end() && last->first == first->first; ++last) balance += last->second;
        if (balance != 0) visit(first->first);
        first = last;
      }
    });
  }

  void number_parts() {
    for (Index t = 0; t < triangles_.size(); ++t) {
      // The representative of a set is its lowest triangle.
      const auto [root, against] = sets_.find(t);
      result_.flip[t] = against;
      if (root == t) {
        result_.part[t] = static_cast<Index>(result_.parts.size());
        result_.parts.emplace_back().first = t;
      }
      result_.part[t] = result_.part[root];
    }
  }

  void turn_lesser_areas() {
    for (Index t = 0; t < triangles_.size(); ++t) {
      PartDirection& part = result_.parts[result_.part[t]];
      ++part.triangles;
      part.oriented = part.oriented && result_.flip[t] == 0;
      if (is_copy(t)) continue;
      const Triangle& c = triangles_[t];
      const Vec3 normal = (points_[c[1]] - points_[c[0]]).cross(points_[c[2]] - points_[c[0]]);
      const double area = 0.5 * normal.norm();
      part.area += area;
      if (result_.flip[t] == 0) part.agreeing += area;
    }
    for (Index t = 0; t < triangles_.size(); ++t) {
      const PartDirection& part = result_.parts[result_.part[t]];
      if (2 * part.agreeing < part.area) result_.flip[t] ^= 1;
    }
    for (PartDirection& part : result_.parts) {
      part.agreeing = std::max(part.agreeing, part.area - part.agreeing);
    }
  }

  void find_open_parts() {
    for (const Disagreement& d : disagreements_) {
      PartDirection& part = result_.parts[result_.part[d.first]];
      part.oriented = false;
      if (d.remains) part.closed = part.orientable = false;
    }
    for_each_unbalanced([&](Index root) { result_.parts[result_.part[root]].closed = false; });
  }

  std::span<const Triangle> triangles_;
  const std::vector<Vec3>& points_;
  EdgeSides edges_;
  TurnedSets sets_;
  std::vector<char> trusted_;
  std::vector<Disagreement> disagreements_;
  std::vector<EdgeSide> others_;         // on edges of one triangle, or of three or more
  std::vector<std::size_t> others_end_;  // of each such edge
  NeighbourDirections result_;
};

}  // namespace

NeighbourDirections orient_neighbours(std::span<const Triangle> triangles,
                                      const std::vector<Vec3>& points) {
  return NeighbourWalk(triangles, points).run();
}

}  // namespace kdm
