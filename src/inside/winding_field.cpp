// SPDX-License-Identifier: MIT
// Sums winding numbers over a tree of dipoles.
#include "inside/winding_field.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/predicates.h"
#include "geometry/solid_angle.h"

namespace kdm {
namespace {

constexpr double kPi = 3.141592653589793;
constexpr Index kLeafSize = 6;
// By level of accuracy: the largest winding number that a node's series may leave out.
constexpr std::array<double, 2> kNodeErrors{5e-2, 4e-3};
// Stands for zero where a zero would lose its sign.
constexpr double kTiny = 1e-30;

Vec3 area_of(const LatticeTriangle& t) {
  const auto area = area_vector(t);
  return 0.5 * Vec3(static_cast<double>(area[0]), static_cast<double>(area[1]),
                    static_cast<double>(area[2]));
}

Vec3 centroid_of(const LatticeTriangle& t) {
  return (to_vec3(t[0]) + to_vec3(t[1]) + to_vec3(t[2])) / 3.0;
}

std::array<Vec3, 3> corners_from(const LatticeTriangle& t, const Vec3& p) {
  return {to_vec3(t[0]) - p, to_vec3(t[1]) - p, to_vec3(t[2]) - p};
}

HalfSolidAngle angle_of(const LatticeTriangle& t, const Vec3& p) {
  const std::array<Vec3, 3> corners = corners_from(t, p);
  return {corners[0], corners[1], corners[2]};
}

// Returns whether the grid vertex, shifted as in geometry/predicates.h, lies behind the triangle's
// plane.
bool is_behind(const LatticeTriangle& t, const LatticePoint& p) {
  const auto normal = area_vector(t);
  std::int64_t side = 0;
  for (int i = 0; i < 3; ++i) side += normal[i] * (t[0][i] - p[i]);
  if (side != 0) return side > 0;
  for (int i = 0; i < 3; ++i) {
    if (normal[i] != 0) return normal[i] < 0;
  }
  return false;
}

}  // namespace

WindingField::WindingField(std::span<const LatticeTriangle> triangles, double threshold)
    : triangles_(triangles), threshold_(threshold) {
  std::vector<Vec3> centroids;
  centroids.reserve(triangles.size());
  for (const LatticeTriangle& t : triangles) centroids.push_back(centroid_of(t));
  order_.resize(triangles.size());
  for (Index i = 0; i < order_.size(); ++i) order_[i] = i;
  nodes_.reserve(triangles.size() / 2 + 1);
  if (!order_.empty()) build(0, static_cast<Index>(order_.size()), centroids);
  if (threshold_ == 0) threshold_ = choose_winding_threshold(*this, triangles);
}

Index WindingField::build(Index begin, Index end, std::vector<Vec3>& centroids) {
  const auto number = static_cast<Index>(nodes_.size());
  nodes_.emplace_back();
  nodes_[number].begin = begin;
  nodes_[number].end = end;
  nodes_[number].right = 0;
  summarise(nodes_[number]);
  if (end - begin <= kLeafSize) return number;
  Vec3 lo = centroids[order_[begin]];
  Vec3 hi = lo;
  for (Index i = begin; i < end; ++i) {
    lo = lo.cwiseMin(centroids[order_[i]]);
    hi = hi.cwiseMax(centroids[order_[i]]);
  }
  int axis = 0;
  (hi - lo).maxCoeff(&axis);
  const Index middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](Index a, Index b) {
                     const double x = centroids[a][axis];
                     const double y = centroids[b][axis];
                     return x != y ? x < y : a < b;
                   });
  build(begin, middle, centroids);
  const Index right = build(middle, end, centroids);
  nodes_[number].right = right;
  return number;
}

void WindingField::summarise(Node& node) const {
  double whole = 0;
  Vec3 weighted = Vec3::Zero();
  Vec3 plain = Vec3::Zero();
  for (Index i = node.begin; i < node.end; ++i) {
    const LatticeTriangle& t = triangles_[order_[i]];
    const double size = area_of(t).norm();
    whole += size;
    weighted += size * centroid_of(t);
    plain += centroid_of(t);
  }
  node.centre =
      whole > 0 ? Vec3(weighted / whole) : Vec3(plain / static_cast<double>(node.end - node.begin));
  node.area = Vec3::Zero();
  node.first = Eigen::Matrix3d::Zero();
  double radius = 0;
  double second = 0;  // integral of the squared offset
  for (Index i = node.begin; i < node.end; ++i) {
    const LatticeTriangle& t = triangles_[order_[i]];
    const Vec3 area = area_of(t);
    const Vec3 offset = centroid_of(t) - node.centre;
    double spread = 0;
    for (int k = 0; k < 3; ++k) {
      radius = std::max(radius, (to_vec3(t[k]) - node.centre).norm());
      spread += (to_vec3(t[k]) - to_vec3(t[next_axis(k)])).squaredNorm();
    }
    node.area += area;
    node.first += area * offset.transpose();
    second += area.norm() * (offset.squaredNorm() + spread / 36.0);
  }
  // The third derivatives of 1/r are at most 6/r^4; half of that is left out, over 4 pi.
  for (int level = 0; level < kLevels; ++level) {
    const double bound = 3.0 / (4.0 * kPi) * second / kNodeErrors[level];
    const double distance = radius + std::sqrt(std::sqrt(bound));
    node.far[level] = distance * distance;
  }
}

// Visits all triangles. Calls add_node(node, r, squared length of r) for nodes that are far enough
// away for the level, r leading from the point to their centre, and add_triangle(triangle) for
// triangles that no such node holds.
template <typename AddNode, typename AddTriangle>
void WindingField::traverse(const Vec3& p, int level, const AddNode& add_node,
                            const AddTriangle& add_triangle) const {
  if (nodes_.empty()) return;
  std::size_t far = 0;
  std::array<Index, 64> stack;
  int open = 0;
  stack[open++] = 0;
  while (open > 0) {
    const Index number = stack[--open];
    const Node& node = nodes_[number];
    const Vec3 r = node.centre - p;
    const double square = r.squaredNorm();
    if (square > node.far[level]) {
      add_node(node, r, square);
      ++far;
    } else if (node.right != 0) {
      stack[open++] = node.right;
      stack[open++] = number + 1;
    } else {
      for (Index i = node.begin; i < node.end; ++i) add_triangle(triangles_[order_[i]]);
      work_ += node.end - node.begin;
    }
  }
  constexpr std::size_t kNodesPerTriangle = 4;  // take the same time
  work_ += far / kNodesPerTriangle + 1;
}

template <typename AddTriangle>
WindingField::Value WindingField::evaluate(const Vec3& p, int level,
                                           const AddTriangle& add_triangle) const {
  Value value;
  AngleSum near;
  int summed = 0;
  traverse(
      p, level,
      [&](const Node& node, const Vec3& r, double square) {
        const double bent = r.dot(node.first * r) / square;
        value.winding += (node.area.dot(r) + node.first.trace() - 3.0 * bent) /
                         (4.0 * kPi * square * std::sqrt(square));
        ++summed;
      },
      [&](const LatticeTriangle& t) { add_triangle(t, near); });
  value.winding += near.turns();
  // The errors of the nodes have different signs, so they grow with the root of their number. Most
  // are far below the bound, which holds for triangles that lie and face the worst way.
  constexpr double kUsualPartOfBound = 0.25;
  value.error = kUsualPartOfBound * kNodeErrors[level] * std::sqrt(static_cast<double>(summed));
  return value;
}

template <typename AddTriangle>
bool WindingField::decide(const Vec3& p, const AddTriangle& add_triangle) const {
  Value value;
  for (int level = 0; level < kLevels; ++level) {
    value = evaluate(p, level, add_triangle);
    if (std::abs(value.winding - threshold_) > value.error) break;
  }
  return value.winding > threshold_;
}

double WindingField::winding(const Vec3& p) const {
  return evaluate(p, kLevels - 1,
                  [&](const LatticeTriangle& t, AngleSum& sum) {
                    const HalfSolidAngle angle = angle_of(t, p);
                    sum.add(angle.re, angle.im);
                  })
      .winding;
}

bool WindingField::inside(const Vec3& p) const {
  return decide(p, [&](const LatticeTriangle& t, AngleSum& sum) {
    const HalfSolidAngle angle = angle_of(t, p);
    sum.add(angle.re, angle.im);
  });
}

bool WindingField::inside(const LatticePoint& p) const {
  // The shift is so small that solid angles stay what they are, and so large that no edge or corner
  // lies at the point itself.
  const Vec3 shifted = to_vec3(p) + Vec3(1.0 / (1 << 10), 1.0 / (1 << 20), 1.0 / (1 << 30));
  return decide(shifted, [&](const LatticeTriangle& t, AngleSum& sum) {
    const HalfSolidAngle angle = angle_of(t, shifted);
    const double im = std::max(std::abs(angle.im), kTiny * std::abs(angle.re));
    sum.add(angle.re, is_behind(t, p) ? im : -im);
  });
}

Vec3 WindingField::gradient(const Vec3& p) const {
  Vec3 sum = Vec3::Zero();
  traverse(
      p, 1,
      [&](const Node& node, const Vec3& r, double square) {
        // The derivatives of the terms that `evaluate` adds up.
        const double bent = r.dot(node.first * r) / square;
        const Vec3 turned = (node.first + node.first.transpose()) * r;
        const double along = node.area.dot(r) + node.first.trace() - 5.0 * bent;
        sum += (3.0 * (along * r + turned) / square - node.area) / (square * std::sqrt(square));
      },
      [&](const LatticeTriangle& t) { sum += solid_angle_gradient(corners_from(t, p)); });
  return sum / (4.0 * kPi);
}

}  // namespace kdm
