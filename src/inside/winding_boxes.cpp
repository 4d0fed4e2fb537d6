// SPDX-License-Identifier: MIT
// Makes boxes with the series of what is far from them.
#include "inside/winding_boxes.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/lattice.h"

namespace kdm {
namespace {

// The largest winding number that the series of one node leaves out within a box.
constexpr double kLeftOutOfBox = 1e-3;
// With so few triangles near, a box is not halved.
constexpr Index kFewTriangles = 32;

// Returns whether the series of a node about the centre of a box is good everywhere within `reach`
// of it. The directional derivatives of order n of 1/r are at most n!/r^(n+1); the first that is
// left out is the fourth for the area and the fifth for the first moment.
bool is_far(const WindingTree::Dipole& dipole, double distance, double reach) {
  const double least = distance - reach;
  if (least <= 0 || least * least <= dipole.far) return false;
  const double cubed = reach * reach * reach;
  const double square = least * least;
  const double left_out = cubed / (std::numbers::pi * square * square * least) *
                          (dipole.area.norm() + 5 * dipole.first.norm() / least);
  return left_out <= kLeftOutOfBox;
}

// Adds the value and the first two derivatives, by the point, of
// (a.r + tr M) / r^3 - 3 r.Mr / r^5, r leading from the point to the dipole; 4 pi is left to do.
void add_series(const WindingTree::Dipole& dipole, const Vec3& r, WindingBoxes::Box& box) {
  const double square = r.squaredNorm();
  const double cubed = square * std::sqrt(square);
  const double scale = 1.0 / (4.0 * std::numbers::pi * cubed);
  const Eigen::Matrix3d both = dipole.first + dipole.first.transpose();
  const Vec3 turned = both * r;
  const double bent = 0.5 * r.dot(turned) / square;
  const double along = dipole.area.dot(r) + dipole.first.trace();
  box.value += scale * (along - 3.0 * bent);
  box.gradient += scale * (3.0 * ((along - 5.0 * bent) * r + turned) / square - dipole.area);
  const Vec3 side = dipole.area - 5.0 / square * turned;
  const Eigen::Matrix3d outer = side * r.transpose();
  Eigen::Matrix3d bend = -3.0 * (outer + outer.transpose() + both);
  bend += 15.0 / square * (along - 7.0 * bent) * r * r.transpose();
  bend.diagonal().array() += 15.0 * bent - 3.0 * along;
  box.bend += scale / square * bend;
}

}  // namespace

double WindingBoxes::Box::value_at(const Vec3& p) const {
  const Vec3 offset = p - centre;
  return value + offset.dot(gradient + 0.5 * (bend * offset));
}

WindingBoxes::WindingBoxes(const WindingTree& tree, double least_width)
    : tree_(tree), least_width_(least_width) {
  constexpr double kHalf = kLatticeSize / 2;
  Box root{Vec3::Constant(kHalf), kHalf};
  if (!tree.empty()) root.near.push_back(0);
  root.last = is_last(root);
  boxes_.push_back(root);
}

bool WindingBoxes::is_last(const Box& box) const {
  if (box.half < least_width_) return true;
  Index triangles = 0;
  for (const Index near : box.near) {
    triangles += tree_.node(near).end - tree_.node(near).begin;
    if (triangles > kFewTriangles) return false;
  }
  return true;
}

const WindingBoxes::Box& WindingBoxes::at(const Vec3& p) {
  Index number = 0;
  while (!boxes_[number].last) {
    const Box& box = boxes_[number];
    std::size_t octant = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (p[axis] >= box.centre[axis]) octant |= std::size_t{1} << axis;
    }
    const Index child = box.children[octant];
    number = child != 0 ? child : make_child(number, octant);
  }
  return boxes_[number];
}

Index WindingBoxes::make_child(Index parent, std::size_t octant) {
  const auto number = static_cast<Index>(boxes_.size());
  boxes_[parent].children[octant] = number;
  const Box& around = boxes_[parent];
  Box box{around.centre, around.half / 2};
  for (int axis = 0; axis < 3; ++axis) {
    box.centre[axis] += (octant >> axis & 1) != 0 ? box.half : -box.half;
  }
  box.value = around.value_at(box.centre);
  box.gradient = around.gradient_at(box.centre);
  box.bend = around.bend;
  for (const Index near : around.near) take(near, box);
  box.last = is_last(box);
  boxes_.push_back(std::move(box));
  return number;
}

// Adds the series of a node that is far from the box, or keeps it; of one that is larger than the
// box each child.
void WindingBoxes::take(Index node, Box& box) const {
  const WindingTree::Node& taken = tree_.node(node);
  const double reach = std::sqrt(3.0) * box.half;
  const Vec3 r = taken.dipole.centre - box.centre;
  if (is_far(taken.dipole, r.norm(), reach)) {
    add_series(taken.dipole, r, box);
  } else if (taken.right == 0 || taken.radius < reach) {
    box.near.push_back(node);
  } else {
    take(node + 1, box);
    take(taken.right, box);
  }
}

}  // namespace kdm
