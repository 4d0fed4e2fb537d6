// SPDX-License-Identifier: MIT
// Builds the tree: each node is halved at the median of its boxes' centres, along the longest side
// of the node's own box.
#include "mesh/box_tree.h"

#include <algorithm>
#include <numeric>

#include "mesh/boxes.h"

namespace kdm {

BoxTree::BoxTree(const std::vector<Box>& boxes) : boxes_(boxes), order_(boxes.size()) {
  std::iota(order_.begin(), order_.end(), Index{0});
  std::vector<Vec3> centres;
  centres.reserve(boxes.size());
  for (const Box& box : boxes) centres.push_back(0.5 * (box.min + box.max));
  nodes_.reserve(boxes.size() / 2 + 1);
  if (!boxes.empty()) build(0, static_cast<Index>(boxes.size()), centres);
}

Index BoxTree::build(Index begin, Index end, const std::vector<Vec3>& centres) {
  const auto number = static_cast<Index>(nodes_.size());
  Box box = boxes_[order_[begin]];
  for (Index i = begin + 1; i < end; ++i) grow(box, boxes_[order_[i]]);
  nodes_.push_back({box, begin, end, 0});
  if (end - begin > kLeafSize) {
    int axis = 0;
    (box.max - box.min).maxCoeff(&axis);
    const Index middle = begin + (end - begin) / 2;
    std::nth_element(
        order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
        [&](Index i, Index j) {
          return centres[i][axis] != centres[j][axis] ? centres[i][axis] < centres[j][axis] : i < j;
        });
    build(begin, middle, centres);
    nodes_[number].right = build(middle, end, centres);
  }
  return number;
}

}  // namespace kdm
