// SPDX-License-Identifier: MIT
// A binary tree of bounding boxes, for pairs of things whose boxes meet and things along a ray.
#pragma once

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

class BoxTree {
 public:
  explicit BoxTree(const std::vector<Box>& boxes);

  /// Calls `visit(i, j)` once, i < j, for every two boxes that meet or touch.
  template <typename Visit>
  void for_each_pair(const Visit& visit) const {
    if (!nodes_.empty()) within(0, visit);
  }

  /// Calls `visit(i)` once for every box that meets or touches this one.
  template <typename Visit>
  void for_each_meeting(const Box& box, const Visit& visit) const {
    any_meeting(box, [&](Index i) {
      visit(i);
      return false;
    });
  }

  /// Whether `test(i)` holds for one of the boxes that meet or touch this one; stops at the first.
  template <typename Test>
  bool any_meeting(const Box& box, const Test& test) const {
    return !nodes_.empty() && any_meeting_below(0, box, test);
  }

  /// Whether `test(i)` holds for one of the boxes that the ray meets or touches; stops at the
  /// first that is found, near ones first. No component of `direction` may be 0.
  template <typename Test>
  bool any_along(const Vec3& origin, const Vec3& direction, const Test& test) const {
    const Vec3 inverse = direction.cwiseInverse();
    return !nodes_.empty() && entry(nodes_[0].box, origin, inverse) < kMissed &&
           any_below(0, origin, inverse, test);
  }

 private:
  struct Node {
    Box box;
    Index begin = 0;  // its things in order_
    Index end = 0;
    Index right = 0;  // the left child follows its parent; 0: a leaf
  };
  static constexpr Index kLeafSize = 8;

  Index build(Index begin, Index end, const std::vector<Vec3>& centres);

  static bool meet(const Box& a, const Box& b) {
    return (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
  }

  static constexpr double kMissed = std::numeric_limits<double>::infinity();

  // Where the ray comes in, in lengths of its direction. Distances to the sides are rounded: the
  // further one is taken a little further.
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
  bool any_below(Index node, const Vec3& origin, const Vec3& inverse, const Test& test) const {
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
      return (near_entry < kMissed && any_below(near, origin, inverse, test)) ||
             (far_entry < kMissed && any_below(far, origin, inverse, test));
    }
    for (Index i = n.begin; i < n.end; ++i) {
      const Index thing = order_[i];
      if (entry(boxes_[thing], origin, inverse) < kMissed && test(thing)) return true;
    }
    return false;
  }

  template <typename Visit>
  void test(Index i, Index j, const Visit& visit) const {
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
  void within(Index node, const Visit& visit) const {
    const Node& n = nodes_[node];
    if (n.right == 0) {
      for (Index i = n.begin; i < n.end; ++i) {
        for (Index j = n.begin; j < i; ++j) test(i, j, visit);
      }
      return;
    }
    within(node + 1, visit);
    within(n.right, visit);
    between(node + 1, n.right, visit);
  }

  template <typename Visit>
  void between(Index a, Index b, const Visit& visit) const {
    const Node& m = nodes_[a];
    const Node& n = nodes_[b];
    if (!meet(m.box, n.box)) return;
    if (m.right == 0 && n.right == 0) {
      for (Index i = m.begin; i < m.end; ++i) {
        for (Index j = n.begin; j < n.end; ++j) test(i, j, visit);
      }
      return;
    }
    // The one with more in it is opened.
    const bool open_first = n.right == 0 || (m.right != 0 && m.end - m.begin >= n.end - n.begin);
    if (open_first) {
      between(a + 1, b, visit);
      between(m.right, b, visit);
    } else {
      between(a, b + 1, visit);
      between(a, n.right, visit);
    }
  }

  const std::vector<Box>& boxes_;
  std::vector<Index> order_;
  std::vector<Node> nodes_;
};

}  // namespace kdm
