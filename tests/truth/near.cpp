// SPDX-License-Identifier: MIT
#include "truth/near.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace kdm::truth {
namespace {

double to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double length = (b - a).squaredNorm();
  const double t = length > 0 ? std::clamp((p - a).dot(b - a) / length, 0.0, 1.0) : 0.0;
  return (a + t * (b - a) - p).norm();
}

// The foot on the plane if it lies within the triangle, else the nearest side counts.
double to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const double sides = std::min({to_segment(p, a, b), to_segment(p, b, c), to_segment(p, c, a)});
  const Vec3 normal = (b - a).cross(c - a);
  if (normal.squaredNorm() == 0) return sides;
  const auto left_of = [&](const Vec3& from, const Vec3& to) {
    return (to - from).cross(p - from).dot(normal) >= 0;
  };
  if (!left_of(a, b) || !left_of(b, c) || !left_of(c, a)) return sides;
  return std::min(sides, std::abs((p - a).dot(normal)) / normal.norm());
}

}  // namespace

Near::Near(const Mesh& mesh) {
  for (const auto& [i, j, k] : mesh.triangles) {
    Face face{mesh.positions[i], mesh.positions[j], mesh.positions[k], Vec3::Zero(), 0};
    face.centre = (face.a + face.b + face.c) / 3;
    for (const Vec3* corner : {&face.a, &face.b, &face.c}) {
      face.radius = std::max(face.radius, (*corner - face.centre).norm());
    }
    faces_.push_back(face);
  }
}

bool Near::within(const Vec3& point, double distance) {
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const std::size_t f = (last_ + i) % faces_.size();
    const Face& face = faces_[f];
    const double reach = (face.radius + distance) * (1 + 1e-9);
    if ((point - face.centre).squaredNorm() > reach * reach) continue;
    if (to_triangle(point, face.a, face.b, face.c) > distance) continue;
    last_ = f;
    return true;
  }
  return false;
}

double Near::distance(const Vec3& point) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Face& face : faces_) {
    least = std::min(least, to_triangle(point, face.a, face.b, face.c));
  }
  return least;
}

}  // namespace kdm::truth
