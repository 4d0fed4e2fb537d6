// SPDX-License-Identifier: MIT
#include "support/solid_check.h"

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <sstream>

namespace kdm::check {
namespace {

template <typename Visit>
void for_each_triangle(const Mesh& mesh, Visit visit) {
  const auto at = [&](Index v) -> const Vec3& { return mesh.positions[v]; };
  for (const auto& [a, b, c] : mesh.triangles) visit(at(a), at(b), at(c));
  for (const auto& [a, b, c, d] : mesh.quads) {
    visit(at(a), at(b), at(c));
    visit(at(a), at(c), at(d));
  }
}

}  // namespace

int winding_number(const Mesh& mesh, const Vec3& point) {
  double half_angles = 0;
  for_each_triangle(mesh, [&](const Vec3& p, const Vec3& q, const Vec3& r) {
    // A. van Oosterom, J. Strackee, The Solid Angle of a Plane Triangle, 1983.
    const Vec3 a = p - point;
    const Vec3 b = q - point;
    const Vec3 c = r - point;
    const double la = a.norm();
    const double lb = b.norm();
    const double lc = c.norm();
    half_angles +=
        std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  });
  return static_cast<int>(std::lround(half_angles / (2 * 3.14159265358979323846)));
}

bool clear_of(const Mesh& mesh, const Vec3& point, double distance) {
  bool clear = true;
  for_each_triangle(mesh, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 min = a.cwiseMin(b).cwiseMin(c);
    const Vec3 max = a.cwiseMax(b).cwiseMax(c);
    if (((min - point).cwiseMax(point - max).array() >= distance).any()) return;
    // Within the box of the triangle: near its plane as well?
    const Vec3 normal = (b - a).cross(c - a);
    if (std::abs(normal.dot(point - a)) < distance * normal.norm() || normal.isZero(0)) {
      clear = false;
    }
  });
  return clear;
}

std::string compare_solids(const Mesh& input, const Mesh& result,
                           const std::function<bool(int)>& inside, double distance, int samples,
                           int* compared) {
  std::mt19937 engine(1);
  Vec3 min = input.positions.at(0);
  Vec3 max = min;
  for (const Vec3& p : input.positions) {
    min = min.cwiseMin(p);
    max = max.cwiseMax(p);
  }
  for (int i = 0; i < samples; ++i) {
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) {
      point[axis] =
          min[axis] + static_cast<double>(engine()) / 4294967296.0 * (max[axis] - min[axis]);
    }
    if (!clear_of(input, point, distance)) continue;
    if (compared != nullptr) ++*compared;
    const int before = winding_number(input, point);
    const int after = winding_number(result, point);
    if (after == (inside(before) ? 1 : 0)) continue;
    std::ostringstream text;
    text << "round (" << point.transpose() << ") the input winds " << before
         << " times, the result " << after;
    return text.str();
  }
  return "";
}

}  // namespace kdm::check
