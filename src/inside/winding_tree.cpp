// SPDX-License-Identifier: MIT
// Builds the tree of dipoles.
#include "inside/winding_tree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace kdm {
namespace {

constexpr Index kLeafSize = 6;
// The largest winding number that a series may leave out.
constexpr double kLeftOut = 2e-3;

Vec3 area_of(const LatticeTriangle& t) {
  const auto area = area_vector(t);
  return 0.5 * Vec3(static_cast<double>(area[0]), static_cast<double>(area[1]),
                    static_cast<double>(area[2]));
}

Vec3 centroid_of(const LatticeTriangle& t) {
  return (to_vec3(t[0]) + to_vec3(t[1]) + to_vec3(t[2])) / 3.0;
}

double radius_about(const Vec3& centre, const LatticeTriangle& t) {
  return std::max({(to_vec3(t[0]) - centre).norm(), (to_vec3(t[1]) - centre).norm(),
                   (to_vec3(t[2]) - centre).norm()});
}

// Returns the mean of the squared offsets of a triangle's points from its centroid, times three.
double spread_of(const LatticeTriangle& t) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) sum += (to_vec3(t[k]) - to_vec3(t[next_axis(k)])).squaredNorm();
  return sum / 36.0;
}

// Returns the squared distance beyond which a series may be used, from the integral of the squared
// offset. The third derivatives of 1/r are at most 6/r^4; half of that is left out, over 4 pi.
double far_from(double radius, double second) {
  const double distance =
      radius + std::sqrt(std::sqrt(3.0 / (4.0 * std::numbers::pi) * second / kLeftOut));
  return distance * distance;
}

}  // namespace

WindingTree::WindingTree(std::span<const LatticeTriangle> triangles) : triangles_(triangles) {
  alone_.reserve(triangles.size());
  for (const LatticeTriangle& t : triangles) {
    const Vec3 centre = centroid_of(t);
    const Vec3 area = area_of(t);
    alone_.push_back({centre, far_from(radius_about(centre, t), area.norm() * spread_of(t)), area});
  }
  order_.resize(triangles.size());
  for (Index i = 0; i < order_.size(); ++i) order_[i] = i;
  nodes_.reserve(triangles.size() / 2 + 1);
  if (!order_.empty()) build(0, static_cast<Index>(order_.size()));
  std::vector<Triangle> sorted;
  sorted.reserve(alone_.size());
  for (const TriangleId t : order_) sorted.push_back(alone_[t]);
  alone_ = std::move(sorted);
}

// The triangles alone are still in the order of the input.
Index WindingTree::build(Index begin, Index end) {
  const auto number = static_cast<Index>(nodes_.size());
  nodes_.emplace_back();
  nodes_[number].begin = begin;
  nodes_[number].end = end;
  nodes_[number].right = 0;
  summarise(nodes_[number]);
  if (end - begin <= kLeafSize) return number;
  Vec3 lo = alone_[order_[begin]].centre;
  Vec3 hi = lo;
  for (Index i = begin; i < end; ++i) {
    lo = lo.cwiseMin(alone_[order_[i]].centre);
    hi = hi.cwiseMax(alone_[order_[i]].centre);
  }
  int axis = 0;
  (hi - lo).maxCoeff(&axis);
  const Index middle = begin + (end - begin) / 2;
  const auto is_before = [&](Index a, Index b) {
    const double x = alone_[a].centre[axis];
    const double y = alone_[b].centre[axis];
    return x != y ? x < y : a < b;
  };
  // Sums depend on the order in each half, which standard libraries choose: it stays as it was.
  std::vector<TriangleId> halves(order_.begin() + begin, order_.begin() + end);
  std::nth_element(halves.begin(), halves.begin() + (middle - begin), halves.end(), is_before);
  const TriangleId first_above = halves[middle - begin];
  std::stable_partition(order_.begin() + begin, order_.begin() + end,
                        [&](TriangleId t) { return is_before(t, first_above); });
  build(begin, middle);
  const Index right = build(middle, end);
  nodes_[number].right = right;
  return number;
}

void WindingTree::summarise(Node& node) const {
  double whole = 0;
  Vec3 weighted = Vec3::Zero();
  Vec3 plain = Vec3::Zero();
  for (Index i = node.begin; i < node.end; ++i) {
    const Triangle& t = alone_[order_[i]];
    const double size = t.area.norm();
    whole += size;
    weighted += size * t.centre;
    plain += t.centre;
  }
  const double count = node.end - node.begin;
  const Vec3 centre = whole > 0 ? Vec3(weighted / whole) : Vec3(plain / count);
  node.dipole = {centre, 0, Vec3::Zero(), Eigen::Matrix3d::Zero()};
  node.radius = 0;
  double second = 0;  // integral of the squared offset
  for (Index i = node.begin; i < node.end; ++i) {
    const Triangle& t = alone_[order_[i]];
    const Vec3 offset = t.centre - centre;
    node.radius = std::max(node.radius, radius_about(centre, triangles_[order_[i]]));
    node.dipole.area += t.area;
    node.dipole.first += t.area * offset.transpose();
    second += t.area.norm() * (offset.squaredNorm() + spread_of(triangles_[order_[i]]));
  }
  node.dipole.far = far_from(node.radius, second);
}

}  // namespace kdm
