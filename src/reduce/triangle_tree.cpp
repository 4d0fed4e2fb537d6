// SPDX-License-Identifier: MIT
// Builds and updates the tree.
#include "reduce/triangle_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "mesh/curve.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

// Returns the triangles in the order of their boxes' centres on a space-filling curve, without
// those whose box is empty.
std::vector<std::uint64_t> along_curve(const std::vector<SmallBox>& boxes) {
  SmallBox all;
  for (const SmallBox& box : boxes) all.grow(box);
  std::array<float, 3> scale{};
  for (int axis = 0; axis < 3; ++axis) {
    const float width = all.max[axis] - all.min[axis];
    // A mesh that is next to flat has one place across it, not infinitely many.
    const float places = width > 0 ? 511.9f / width : 0;
    scale[axis] = std::isfinite(places) ? places : 0;
  }
  std::vector<std::uint64_t> codes;
  codes.reserve(boxes.size());
  for (TriangleId t = 0; t < boxes.size(); ++t) {
    const SmallBox& box = boxes[t];
    if (box.min[0] > box.max[0]) continue;
    std::array<std::uint32_t, 3> cell{};
    for (int axis = 0; axis < 3; ++axis) {
      const float twice = box.min[axis] - all.min[axis] + (box.max[axis] - all.min[axis]);
      cell[axis] = static_cast<std::uint32_t>(twice * scale[axis]);
    }
    codes.push_back(std::uint64_t{place_on_curve(cell)} << 32 | t);
  }
  sort_numbers(std::span(codes));
  return codes;
}

}  // namespace

TriangleTree::TriangleTree(std::vector<SmallBox> boxes) : boxes_(std::move(boxes)) {
  const std::vector<std::uint64_t> codes = along_curve(boxes_);
  if (codes.empty()) return;
  leaves_ = std::bit_ceil(static_cast<Index>((codes.size() + kLeafSize - 1) / kLeafSize));
  order_.assign(std::size_t{leaves_} * kLeafSize, kNone);
  place_.assign(boxes_.size(), kNone);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    order_[i] = static_cast<TriangleId>(codes[i] & 0xffffffffu);
    place_[order_[i]] = static_cast<Index>(i);
  }
  nodes_.resize(std::size_t{leaves_} * 2);
  for (Index leaf = 0; leaf < leaves_; ++leaf) nodes_[leaves_ + leaf] = leaf_box(leaf);
  for (Index node = leaves_ - 1; node > 0; --node) {
    nodes_[node] = nodes_[2 * node];
    nodes_[node].grow(nodes_[2 * node + 1]);
  }
}

SmallBox TriangleTree::leaf_box(Index leaf) const {
  SmallBox box;
  for (Index i = leaf * kLeafSize; i < (leaf + 1) * kLeafSize; ++i) {
    if (order_[i] != kNone) box.grow(boxes_[order_[i]]);
  }
  return box;
}

void TriangleTree::change(TriangleId t, const SmallBox& box) {
  boxes_[t] = box;
  const Index leaf = place_[t] / kLeafSize;
  Index node = leaves_ + leaf;
  SmallBox around = leaf_box(leaf);
  while (!(around == nodes_[node])) {
    nodes_[node] = around;
    if (node == 1) return;
    around.grow(nodes_[node ^ 1]);
    node /= 2;
  }
}

}  // namespace kdm
