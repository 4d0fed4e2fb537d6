// SPDX-License-Identifier: MIT
// A binary tree over boxes: finds the boxes that meet each other, a given box or a ray, and what is
// nearest to a point.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

/// Finds boxes by where they are and names them by their places in the given vector. Boxes that
/// touch count as meeting. A search takes about logarithmic time and the time for what it finds,
/// unless very many boxes overlap.
class BoxTree {
 public:
  /// How boxes are divided among nodes. Both take time n log n.
  enum class Division {
    kMedians,  ///< at the medians of their centres
    kCurve     ///< along a space-filling curve: in a tenth of the time, for few searches
  };
  /// Builds the tree. `boxes` must outlive it; none may be empty.
  explicit BoxTree(const std::vector<Box>& boxes, Division division = Division::kMedians);

  /// Calls `visit(i, j)` once, i < j, for every two boxes that meet.
  template <typename Visit>
  void for_each_pair(const Visit& visit) const {
    if (!nodes_.empty()) pairs_within(0, visit);
  }

  /// Calls `visit(i)` once for every box that meets the given one.
  template <typename Visit>
  void for_each_meeting(const Box& box, const Visit& visit) const {
    any_meeting(box, [&](Index i) {
      visit(i);
      return false;
    });
  }

  /// Tells whether `test(i)` holds for one of the boxes that meet the given one. Calls it until it
  /// does.
  template <typename Test>
  bool any_meeting(const Box& box, const Test& test) const {
    return !nodes_.empty() && any_meeting_below(0, box, test);
  }

  /// Tells whether `test(i)` holds for one of the boxes that the ray meets. Calls it until it does,
  /// for near boxes rather than far ones. No component of `direction` may be 0.
  template <typename Test>
  bool any_along(const Vec3& origin, const Vec3& direction, const Test& test) const {
    const Vec3 inverse = direction.cwiseInverse();
    return !nodes_.empty() && entry(nodes_[0].box, origin, inverse) < kMissed &&
           any_along_below(0, origin, inverse, test);
  }

  /// Returns the least of `bound` and of `squared_distance(i)`, the squared distance of the point
  /// from what is in box i. Asks for near boxes first, and stops at what is not above `enough`.
  template <typename SquaredDistance>
  double least(const Vec3& point, double bound, double enough,
               const SquaredDistance& squared_distance) const {
    if (!nodes_.empty() && bound > enough) least_below(0, point, enough, squared_distance, bound);
    return bound;
  }

 private:
  struct Node {
    Box box;
    Index begin = 0;  // order_[begin] to order_[end - 1] are the boxes in it
    Index end = 0;
    Index right = 0;  // the right child, or 0 for a leaf; the left child follows its parent
  };
  static constexpr Index kLeafSize = 8;

  Index build_at_medians(Index begin, Index end, const std::vector<Vec3>& centres);
  Index build_along_curve(Index begin, Index end, const std::vector<std::uint64_t>& codes);

  static bool meet(const Box& a, const Box& b) {
    return (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
  }

  static constexpr double kMissed = std::numeric_limits<double>::infinity();

  // Returns where the ray enters the box, in lengths of its direction, or kMissed. Since distances
  // to the box's sides are rounded, the ray is taken to leave the box a little further away.
  static double entry(const Box& box, const Vec3& origin, const Vec3& inverse) {
    constexpr double kOutwards = 1 + 1e-15;
    double nearest = 0;
    double furthest = kMissed;
    for (int axis = 0; axis < 3; ++axis) {
      const double a = (box.min[axis] - origin[axis]) * inverse[axis];
      const double b = (box.max[axis] - origin[axis]) * inverse[axis];
      nearest = std::max(nearest, std::min(a, b));
      furthest = std::min(furthest, std::max(a, b) * kOutwards);
    }
    return nearest <= furthest ? nearest : kMissed;
  }

  template <typename Test>
  bool any_along_below(Index node, const Vec3& origin, const Vec3& inverse,
                       const Test& test) const {
    const Node& n = nodes_[node];
    if (n.right != 0) {
      Index near = node + 1;
      Index far = n.right;
      double near_entry = entry(nodes_[near].box, origin, inverse);
      double far_entry = entry(nodes_[far].box, origin, inverse);
      if (far_entry < near_entry) {
        std::swap(near, far);
        std::swap(near_entry, far_entry);
      }
      return (near_entry < kMissed && any_along_below(near, origin, inverse, test)) ||
             (far_entry < kMissed && any_along_below(far, origin, inverse, test));
    }
    for (Index i = n.begin; i < n.end; ++i) {
      const Index box = order_[i];
      if (entry(boxes_[box], origin, inverse) < kMissed && test(box)) return true;
    }
    return false;
  }

  static double squared_gap(const Box& box, const Vec3& p) {
    return (p - p.cwiseMax(box.min).cwiseMin(box.max)).squaredNorm();
  }

  template <typename SquaredDistance>
  void least_below(Index node, const Vec3& point, double enough,
                   const SquaredDistance& squared_distance, double& bound) const {
    const Node& n = nodes_[node];
    if (n.right == 0) {
      for (Index i = n.begin; i < n.end; ++i) {
        if (squared_gap(boxes_[order_[i]], point) < bound) {
          bound = std::min(bound, squared_distance(order_[i]));
        }
      }
      return;
    }
    Index near = node + 1;
    Index far = n.right;
    double near_gap = squared_gap(nodes_[near].box, point);
    double far_gap = squared_gap(nodes_[far].box, point);
    if (far_gap < near_gap) {
      std::swap(near, far);
      std::swap(near_gap, far_gap);
    }
    if (near_gap < bound) least_below(near, point, enough, squared_distance, bound);
    if (far_gap < bound && bound > enough) {
      least_below(far, point, enough, squared_distance, bound);
    }
  }

  // i and j are places in order_.
  template <typename Visit>
  void visit_if_meeting(Index i, Index j, const Visit& visit) const {
    if (meet(boxes_[order_[i]], boxes_[order_[j]])) {
      visit(std::min(order_[i], order_[j]), std::max(order_[i], order_[j]));
    }
  }

  template <typename Test>
  bool any_meeting_below(Index node, const Box& box, const Test& test) const {
    const Node& n = nodes_[node];
    if (!meet(n.box, box)) return false;
    if (n.right != 0) {
      return any_meeting_below(node + 1, box, test) || any_meeting_below(n.right, box, test);
    }
    for (Index i = n.begin; i < n.end; ++i) {
      if (meet(boxes_[order_[i]], box) && test(order_[i])) return true;
    }
    return false;
  }

  template <typename Visit>
  void pairs_within(Index node, const Visit& visit) const {
    const Node& n = nodes_[node];
    if (n.right == 0) {
      for (Index i = n.begin; i < n.end; ++i) {
        for (Index j = n.begin; j < i; ++j) visit_if_meeting(i, j, visit);
      }
      return;
    }
    pairs_within(node + 1, visit);
    pairs_within(n.right, visit);
    pairs_between(node + 1, n.right, visit);
  }

  template <typename Visit>
  void pairs_between(Index a, Index b, const Visit& visit) const {
    const Node& m = nodes_[a];
    const Node& n = nodes_[b];
    if (!meet(m.box, n.box)) return;
    if (m.right == 0 && n.right == 0) {
      for (Index i = m.begin; i < m.end; ++i) {
        for (Index j = n.begin; j < n.end; ++j) visit_if_meeting(i, j, visit);
      }
      return;
    }
    // Go on with the children of the node that holds more boxes.
    const bool open_first = n.right == 0 || (m.right != 0 && m.end - m.begin >= n.end - n.begin);
    if (open_first) {
      pairs_between(a + 1, b, visit);
      pairs_between(m.right, b, visit);
    } else {
      pairs_between(a, b + 1, visit);
      pairs_between(a, n.right, visit);
    }
  }

  const std::vector<Box>& boxes_;
  std::vector<Index> order_;  // numbers of the boxes, those of each node side by side
  std::vector<Node> nodes_;
};

}  // namespace kdm
