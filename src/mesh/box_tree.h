// SPDX-License-Identifier: MIT
// A binary tree of bounding boxes, for pairs of things whose boxes meet.
#pragma once

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
    if (!nodes_.empty()) below(0, box, visit);
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

  template <typename Visit>
  void test(Index i, Index j, const Visit& visit) const {
    if (meet(boxes_[order_[i]], boxes_[order_[j]])) {
      visit(std::min(order_[i], order_[j]), std::max(order_[i], order_[j]));
    }
  }

  template <typename Visit>
  void below(Index node, const Box& box, const Visit& visit) const {
    const Node& n = nodes_[node];
    if (!meet(n.box, box)) return;
    if (n.right != 0) {
      below(node + 1, box, visit);
      below(n.right, box, visit);
      return;
    }
    for (Index i = n.begin; i < n.end; ++i) {
      if (meet(boxes_[order_[i]], box)) visit(order_[i]);
    }
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
