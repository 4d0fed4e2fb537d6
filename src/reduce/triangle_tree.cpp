// SPDX-License-Identifier: MIT
// Builds and updates the tree.
#include "reduce/triangle_tree.h"

#include <algorithm>
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

TriangleTree::TriangleTree(const std::vector<SmallBox>& boxes) {
  const std::vector<std::uint64_t> codes = along_curve(boxes);
  if (codes.empty()) return;
  order_.reserve(codes.size());
  place_.assign(boxes.size(), kNone);
  for (const std::uint64_t code : codes) {
    const auto t = static_cast<TriangleId>(code & 0xffffffffu);
    place_[t] = static_cast<Index>(order_.size());
    order_.push_back(t);
  }
  std::vector<SmallBox> children;
  children.reserve(order_.size());
  for (const TriangleId t : order_) children.push_back(boxes[t]);
  do {
    levels_.push_back(static_cast<Index>(nodes_.size()));
    const std::size_t count = children.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (i % kChildren == 0) nodes_.emplace_back();
      nodes_.back().set(child_of(static_cast<Index>(i)), children[i]);
    }
    children.clear();
    for (std::size_t i = levels_.back(); i < nodes_.size(); ++i) {
      children.push_back(nodes_[i].around());
    }
  } while (children.size() > 1);
}

void TriangleTree::change(TriangleId t, const SmallBox& box) {
  Index number = place_[t];
  SmallBox changed = box;
  for (const Index level : levels_) {
    FourBoxes& node = nodes_[level + number / kChildren];
    if (node[child_of(number)] == changed) return;
    node.set(child_of(number), changed);
    changed = node.around();
    number /= kChildren;
  }
}

void TriangleTree::rebuild() {
  std::vector<SmallBox> boxes;
  boxes.reserve(place_.size());
  for (TriangleId t = 0; t < place_.size(); ++t) boxes.push_back(box(t));
  *this = TriangleTree(boxes);
}

}  // namespace kdm
