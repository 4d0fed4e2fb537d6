// SPDX-License-Identifier: MIT
// Joins neighbours by a union-find in which each triangle knows whether it must be turned for it to
// agree with its set's representative. Edges whose triangles agree are taken first, because they
// never contradict each other.
#include "prepare/neighbours.h"

#include <algorithm>
#include <array>

#include "geometry/triangle.h"
#include "mesh/disjoint_sets.h"
#include "mesh/edge_sides.h"
#include "mesh/same_corners.h"
#include "mesh/sort.h"
#include "prepare/cancel.h"
#include "prepare/twins.h"
#include "prepare/two_sided.h"

namespace kdm {
namespace {

// Disjoint sets of triangles that know of any two in one set whether they face the same way. The
// lowest triangle of a set is its representative.
class TurnedSets {
 public:
  explicit TurnedSets(std::size_t size) : parent_(size), against_parent_(size) {
    std::iota(parent_.begin(), parent_.end(), TriangleId{0});
  }

  struct Found {
    TriangleId root;  // the representative
    bool against;     // whether the triangle faces the other way than the representative
  };

  Found find(TriangleId t) {
    TriangleId root = t;
    bool against = false;
    while (parent_[root] != root) {
      against = against != against_parent_.test(root);
      root = parent_[root];
    }
    // Hang all triangles on the way to the root directly below it.
    for (bool rest = against; parent_[t] != root && t != root;) {
      const TriangleId next = parent_[t];
      const bool step = against_parent_.test(t);
      parent_[t] = root;
      against_parent_.set(t, rest);
      rest = rest != step;
      t = next;
    }
    return {root, against};
  }

  // Joins the sets of two triangles, which face the same way or not (`against`). Returns false if
  // they are in one set already and face each other differently there.
  bool join(TriangleId a, TriangleId b, bool against) {
    const Found of_a = find(a);
    const Found of_b = find(b);
    const bool between = (of_a.against != of_b.against) != against;
    if (of_a.root == of_b.root) return !between;
    const TriangleId joined = std::max(of_a.root, of_b.root);
    parent_[joined] = std::min(of_a.root, of_b.root);
    against_parent_.set(joined, between);
    return true;
  }

 private:
  std::vector<TriangleId> parent_;
  Marks against_parent_;
};

// Two neighbours that run the same way along their edge.
struct Disagreement {
  double squared_length;  // of the edge
  TriangleId first;
  TriangleId second;
  bool remains = false;  // the two cannot agree, whatever is turned
};

class NeighbourWalk {
 public:
  NeighbourWalk(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                const Topology& topology)
      : triangles_(triangles),
        points_(points),
        topology_(topology),
        sets_(triangles.size()),
        trusted_(triangles.size()) {
    result_.must_turn.assign(triangles.size());
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
  SideId opposite(SideId side) const { return topology_.opposite[side]; }
  bool is_copy(TriangleId triangle) const { return result_.copy_of[triangle] != kNone; }

  // Marks the triangles that are turned rightly as they are. In a component, joined by edges of any
  // kind, that uses every edge equally often in both directions they are, unless it has two sides.
  void find_trusted() {
    // Without edges of three or more triangles nothing is in doubt.
    if (topology_.non_manifold_edges == 0) return;
    DisjointSets components = join_at_edges(triangles_, points(), topology_);
    const Marks two_sided = find_two_sided_parts(
        triangles_, points_, find_opposite_pairs(triangles_, points(), topology_), components, 2);
    Marks is_unbalanced(triangles_.size());
    for (SideId side = 0; side < topology_.opposite.size(); ++side) {
      if (opposite(side) == kNone) is_unbalanced.set(components.find(triangle_of(side)));
    }
    for (TriangleId t = 0; t < trusted_.size(); ++t) {
      trusted_.set(t, !two_sided.test(t) && !is_unbalanced.test(components.find(t)));
    }
  }

  void find_copies() {
    const std::vector<TriangleId> twins = find_possible_twins(topology_);
    std::vector<Triangle> corners;
    for (const TriangleId t : twins) corners.push_back(triangles_[t]);
    for_each_corner_set(corners, points(), [&](std::span<const SortedCorners> group) {
      const TriangleId first = twins[group[0].triangle];
      if (trusted_.test(first)) return;
      for (const SortedCorners& other : group.subspan(1)) {
        const TriangleId copy = twins[other.triangle];
        result_.copy_of[copy] = first;
        sets_.join(first, copy, other.turned != group[0].turned);
      }
    });
  }

  // Marks the sides on edges other than the usual one, which has two sides that run against each
  // other, of triangles that are no copies.
  Marks unusual_sides() const {
    Marks unusual(topology_.opposite.size());
    for (const SideId side : topology_.non_manifold_sides) unusual.set(side);
    for (SideId side = 0; side < unusual.size(); ++side) {
      const SideId beyond = opposite(side);
      if (beyond == kNone || is_copy(triangle_of(side)) || is_copy(triangle_of(beyond))) {
        unusual.set(side);
      }
    }
    return unusual;
  }

  void join_neighbours() {
    const Marks unusual = unusual_sides();
    for (SideId side = 0; side < unusual.size(); ++side) {
      if (unusual.test(side) || opposite(side) < side) continue;  // each pair once
      sets_.join(triangle_of(side), triangle_of(opposite(side)), false);
    }
    std::vector<EdgeSide> sides;
    const EdgeSides edges(triangles_, points(), unusual);
    edges.for_each_edge([&](PointId lower, std::span<const EdgeSide> edge) {
      sides.clear();
      for (const EdgeSide& s : edge) {
        if (!is_copy(triangle_of(s.side))) sides.push_back(s);
      }
      if (sides.size() != 2) {
        other_sides_.insert(other_sides_.end(), sides.begin(), sides.end());
        other_sides_end_.push_back(other_sides_.size());
      } else if (sides[0].forward != sides[1].forward) {
        sets_.join(triangle_of(sides[0].side), triangle_of(sides[1].side), false);
      } else {
        disagreements_.push_back({(points_[lower] - points_[sides[0].upper]).squaredNorm(),
                                  triangle_of(sides[0].side), triangle_of(sides[1].side)});
      }
    });
    sort_by(disagreements_, [](const Disagreement& a, const Disagreement& b) {
      return a.squared_length != b.squared_length
                 ? a.squared_length > b.squared_length
                 : std::array{a.first, a.second} < std::array{b.first, b.second};
    });
    for (Disagreement& d : disagreements_) {
      d.remains = !sets_.join(d.first, d.second, true);
      result_.contradictions += d.remains ? 1 : 0;
    }
  }

  // Joins trusted sets that are open by themselves along the edges at which they close each other.
  void join_trusted() {
    Marks is_open(triangles_.size());
    for_each_unbalanced([&](TriangleId root) { is_open.set(root); });
    for (TriangleId t = 0; t < triangles_.size(); ++t) {
      is_open.set(t, is_open.test(sets_.find(t).root));
    }
    for_each_other_edge([&](std::span<const EdgeSide> edge) {
      TriangleId first = kNone;
      for (const EdgeSide& s : edge) {
        const TriangleId t = triangle_of(s.side);
        if (!trusted_.test(t) || !is_open.test(t)) continue;
        if (first == kNone) first = t;
        sets_.join(first, t, false);
      }
    });
  }

  // Calls `visit(sides)` for each edge of one triangle, or of three or more.
  template <typename Visit>
  void for_each_other_edge(const Visit& visit) const {
    std::size_t begin = 0;
    for (const std::size_t end : other_sides_end_) {
      visit(std::span<const EdgeSide>(other_sides_.data() + begin, end - begin));
      begin = end;
    }
  }

  // Calls `visit(root)` for each edge of one triangle, or of three or more, and each set that uses
  // the edge more often in one direction.
  template <typename Visit>
  void for_each_unbalanced(const Visit& visit) {
    std::vector<std::pair<TriangleId, int>> uses;  // root of the set, direction
    for_each_other_edge([&](std::span<const EdgeSide> edge) {
      uses.clear();
      for (const EdgeSide& s : edge) {
        const TurnedSets::Found found = sets_.find(triangle_of(s.side));
        uses.emplace_back(found.root, s.forward != found.against ? 1 : -1);
      }
      sort_up(uses);
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
    for (TriangleId t = 0; t < triangles_.size(); ++t) {
      // The representative of a set is its lowest triangle.
      const auto [root, against] = sets_.find(t);
      result_.must_turn.set(t, against);
      if (root == t) {
        result_.part[t] = static_cast<Index>(result_.parts.size());
        result_.parts.emplace_back().first = t;
      }
      result_.part[t] = result_.part[root];
    }
  }

  void turn_lesser_areas() {
    for (TriangleId t = 0; t < triangles_.size(); ++t) {
      PartDirection& part = result_.parts[result_.part[t]];
      ++part.triangles;
      part.oriented = part.oriented && !result_.must_turn.test(t);
      if (is_copy(t)) continue;
      const Triangle& c = triangles_[t];
      const double area =
          0.5 * doubled_area_vector(points_[c[0]], points_[c[1]], points_[c[2]]).norm();
      part.area += area;
      if (!result_.must_turn.test(t)) part.agreeing += area;
    }
    for (TriangleId t = 0; t < triangles_.size(); ++t) {
      const PartDirection& part = result_.parts[result_.part[t]];
      if (2 * part.agreeing < part.area) result_.must_turn.set(t, !result_.must_turn.test(t));
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
    for_each_unbalanced([&](TriangleId root) { result_.parts[result_.part[root]].closed = false; });
  }

  std::span<const Triangle> triangles_;
  const std::vector<Vec3>& points_;
  const Topology& topology_;
  TurnedSets sets_;
  Marks trusted_;  // triangles of components that are closed and oriented as they are
  std::vector<Disagreement> disagreements_;
  std::vector<EdgeSide> other_sides_;         // on edges of one triangle, or of three or more
  std::vector<std::size_t> other_sides_end_;  // per such edge
  NeighbourDirections result_;
};

}  // namespace

NeighbourDirections orient_neighbours(std::span<const Triangle> triangles,
                                      const std::vector<Vec3>& points, const Topology& topology) {
  return NeighbourWalk(triangles, points, topology).run();
}

}  // namespace kdm
