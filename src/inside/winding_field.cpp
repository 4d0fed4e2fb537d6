// SPDX-License-Identifier: MIT
// Sums winding numbers over a tree of dipoles and the series of boxes.
#include "inside/winding_field.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/predicates.h"
#include "geometry/solid_angle.h"

namespace kdm {
namespace {

// How many spacings wide the smallest boxes are.
constexpr double kSpacingsInABox = 4;
// Stands for zero where a zero would lose its sign.
constexpr double kTiny = 1e-30;

std::array<Vec3, 3> corners_from(const LatticeTriangle& t, const Vec3& p) {
  return {to_vec3(t[0]) - p, to_vec3(t[1]) - p, to_vec3(t[2]) - p};
}

HalfSolidAngle angle_of(const LatticeTriangle& t, const Vec3& p) {
  const std::array<Vec3, 3> corners = corners_from(t, p);
  return {corners[0], corners[1], corners[2]};
}

// Adds the solid angle of a triangle seen from a point.
struct AddAngle {
  const Vec3& p;
  void operator()(const LatticeTriangle& t, AngleSum& sum) const {
    const HalfSolidAngle angle = angle_of(t, p);
    sum.add(angle.re, angle.im);
  }
};

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

WindingField::WindingField(std::span<const LatticeTriangle> triangles, double threshold,
                           double spacing)
    : tree_(std::make_shared<WindingTree>(triangles)),
      boxes_(*tree_, kSpacingsInABox * spacing),
      threshold_(threshold) {
  if (threshold_ == 0) threshold_ = choose_winding_threshold(*this, triangles);
}

// Sums over some nodes of the tree.
template <typename AddNear>
double WindingField::sum(const Vec3& p, std::span<const Index> roots,
                         const AddNear& add_near) const {
  double far = 0;
  AngleSum near;
  work_ += tree_->visit(
      p, roots,
      [&](const WindingTree::Dipole& dipole, const Vec3& r, double square) {
        const double bent = r.dot(dipole.first * r) / square;
        far +=
            (dipole.area.dot(r) + dipole.first.trace() - 3.0 * bent) / (square * std::sqrt(square));
      },
      [&](const WindingTree::Triangle& triangle, const Vec3& r, double square) {
        far += triangle.area.dot(r) / (square * std::sqrt(square));
      },
      [&](const LatticeTriangle& t) { add_near(t, near); });
  return far / (4.0 * std::numbers::pi) + near.turns();
}

template <typename AddNear>
double WindingField::excess_with(const Vec3& p, const AddNear& add_near) const {
  const WindingBoxes::Box& box = boxes_.at(p);
  return box.value_at(p) + sum(p, box.near, add_near) - threshold_;
}

double WindingField::winding(const Vec3& p) const {
  if (tree_->empty()) return 0;
  constexpr std::array<Index, 1> kWholeTree{0};
  return sum(p, kWholeTree, AddAngle{p});
}

double WindingField::excess(const Vec3& p) const { return excess_with(p, AddAngle{p}); }

bool WindingField::inside(const LatticePoint& p) const {
  // The shift is so small that solid angles stay what they are, and so large that no edge or corner
  // lies at the point itself.
  const Vec3 shifted = to_vec3(p) + Vec3(1.0 / (1 << 10), 1.0 / (1 << 20), 1.0 / (1 << 30));
  return excess_with(shifted, [&](const LatticeTriangle& t, AngleSum& sum) {
           const HalfSolidAngle angle = angle_of(t, shifted);
           const double im = std::max(std::abs(angle.im), kTiny * std::abs(angle.re));
           sum.add(angle.re, is_behind(t, p) ? im : -im);
         }) > 0;
}

Vec3 WindingField::gradient(const Vec3& p) const {
  const WindingBoxes::Box& box = boxes_.at(p);
  Vec3 sum = Vec3::Zero();
  work_ += tree_->visit(
      p, box.near,
      [&](const WindingTree::Dipole& dipole, const Vec3& r, double square) {
        // The derivatives of the terms that `sum` adds up.
        const double bent = r.dot(dipole.first * r) / square;
        const Vec3 turned = (dipole.first + dipole.first.transpose()) * r;
        const double along = dipole.area.dot(r) + dipole.first.trace() - 5.0 * bent;
        sum += (3.0 * (along * r + turned) / square - dipole.area) / (square * std::sqrt(square));
      },
      [&](const WindingTree::Triangle& triangle, const Vec3& r, double square) {
        sum += (3.0 * triangle.area.dot(r) / square * r - triangle.area) /
               (square * std::sqrt(square));
      },
      [&](const LatticeTriangle& t) { sum += solid_angle_gradient(corners_from(t, p)); });
  return box.gradient_at(p) + sum / (4.0 * std::numbers::pi);
}

}  // namespace kdm
