// SPDX-License-Identifier: MIT
// Builds the tree: each node is halved at the median of its boxes' centres, along the longest side
// of the node's own box, or where its part of a curve passes from one half of a cell to the other.
#include "mesh/box_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "mesh/boxes.h"
#include "mesh/curve.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

std::vector<Vec3> centres_of(const std::vector<Box>& boxes) {
  std::vector<Vec3> centres;
  centres.reserve(boxes.size());
  for (const Box& box : boxes) centres.push_back(0.5 * (box.min + box.max));
  return centres;
}

// Returns a code for each point, in their order along a space-filling curve. The upper half of a
// code is the place on the curve, whose every bit halves a cell; the lower half is the point's
// number.
std::vector<std::uint64_t> sort_along_curve(const std::vector<Vec3>& points) {
  Box all;
  for (const Vec3& p : points) grow(all, p);
  const Vec3 width = all.max - all.min;
  Vec3 scale = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    // Points that are next to flat have one place across, not infinitely many.
    const double places = width[axis] > 0 ? 1023.9 / width[axis] : 0;
    if (std::isfinite(places)) scale[axis] = places;
  }
  std::vector<std::uint64_t> codes;
  codes.reserve(points.size());
  for (Index i = 0; i < points.size(); ++i) {
    std::array<std::uint32_t, 3> cell{};
    for (int axis = 0; axis < 3; ++axis) {
      cell[axis] = static_cast<std::uint32_t>((points[i][axis] - all.min[axis]) * scale[axis]);
    }
    codes.push_back(std::uint64_t{place_on_curve(cell)} << 32 | i);
  }
  sort_numbers(std::span(codes));
  return codes;
}

}  // namespace

BoxTree::BoxTree(const std::vector<Box>& boxes, Division division)
    : boxes_(boxes), order_(boxes.size()) {
  std::iota(order_.begin(), order_.end(), Index{0});
  const std::vector<Vec3> centres = centres_of(boxes);
  nodes_.reserve(boxes.size() / 2 + 1);
  if (boxes.empty()) return;
  const auto count = static_cast<Index>(boxes.size());
  if (division == Division::kMedians) {
    build_at_medians(0, count, centres);
  } else {
    const std::vector<std::uint64_t> codes = sort_along_curve(centres);
    for (Index i = 0; i < count; ++i) order_[i] = static_cast<Index>(codes[i]);
    build_along_curve(0, count, codes);
  }
}

Index BoxTree::build_at_medians(Index begin, Index end, const std::vector<Vec3>& centres) {
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
    build_at_medians(begin, middle, centres);
    nodes_[number].right = build_at_medians(middle, end, centres);
  }
  return number;
}

Index BoxTree::build_along_curve(Index begin, Index end, const std::vector<std::uint64_t>& codes) {
  const auto number = static_cast<Index>(nodes_.size());
  nodes_.push_back({boxes_[order_[begin]], begin, end, 0});
  if (end - begin > kLeafSize) {
    // The codes agree above the highest bit in which the first and the last differ.
    const std::uint64_t half = std::bit_floor(codes[begin] ^ codes[end - 1]);
    const auto first = codes.begin() + begin;
    const auto middle = static_cast<Index>(
        std::partition_point(first, codes.begin() + end,
                             [half](std::uint64_t code) { return (code & half) == 0; }) -
        codes.begin());
    const Index left = build_along_curve(begin, middle, codes);
    const Index right = build_along_curve(middle, end, codes);
    nodes_[number].right = right;
    nodes_[number].box = nodes_[left].box;
    grow(nodes_[number].box, nodes_[right].box);
  } else {
    for (Index i = begin + 1; i < end; ++i) grow(nodes_[number].box, boxes_[order_[i]]);
  }
  return number;
}

}  // namespace kdm
