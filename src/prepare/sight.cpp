// SPDX-License-Identifier: MIT
// Shears space so that the ray runs along an axis; then the ray meets a triangle if its origin lies
// within the triangle's outline, seen along that axis. The two triangles at an edge find signs that
// are exact opposites there, so no ray slips through between them (S. Woop, C. Benthin, I. Wald,
// Watertight Ray/Triangle Intersection, 2013).
#include "prepare/sight.h"

#include <cmath>

#include "mesh/boxes.h"

namespace kdm {
namespace {

// How near triangles are overlooked, as a part of the diagonal of the mesh's box.
constexpr double kOverlooked = 1e-7;

class ShearedRay {
 public:
  ShearedRay(const Vec3& origin, const Vec3& direction) : origin_(origin) {
    direction.cwiseAbs().maxCoeff(&z_);
    x_ = (z_ + 1) % 3;
    y_ = (z_ + 2) % 3;
    shear_x_ = direction[x_] / direction[z_];
    shear_y_ = direction[y_] / direction[z_];
    forward_ = direction[z_] > 0;
  }

  // Returns 0 if the ray does not meet the triangle further away than `least_distance`, measured
  // along the axis on which the ray moves most; else 1 if it leaves through the triangle, which it
  // meets from behind, and -1 if it enters.
  int crossing(const Vec3& a, const Vec3& b, const Vec3& c, double least_distance) const {
    const Vec3 p = sheared(a);
    const Vec3 q = sheared(b);
    const Vec3 r = sheared(c);
    const double u = r[0] * q[1] - r[1] * q[0];
    const double v = p[0] * r[1] - p[1] * r[0];
    const double w = q[0] * p[1] - q[1] * p[0];
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return 0;
    const double sum = u + v + w;
    if (sum == 0) return 0;  // seen edge-on: its neighbours stop the ray
    const double distance = (u * p[2] + v * q[2] + w * r[2]) / sum;
    if (!((forward_ ? distance : -distance) > least_distance)) return 0;
    return forward_ == (sum < 0) ? 1 : -1;
  }

 private:
  Vec3 sheared(const Vec3& point) const {
    const Vec3 p = point - origin_;
    return {p[x_] - shear_x_ * p[z_], p[y_] - shear_y_ * p[z_], p[z_]};
  }

  Vec3 origin_;
  int x_ = 0;
  int y_ = 1;
  int z_ = 2;
  double shear_x_ = 0;
  double shear_y_ = 0;
  bool forward_ = true;
};

std::vector<TriangleId> all_but(const Marks& left_out) {
  std::vector<TriangleId> numbers;
  for (TriangleId t = 0; t < left_out.size(); ++t) {
    if (!left_out.test(t)) numbers.push_back(t);
  }
  return numbers;
}

std::vector<Box> boxes_of(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                          const std::vector<TriangleId>& numbers) {
  std::vector<Box> boxes;
  boxes.reserve(numbers.size());
  for (const TriangleId number : numbers) {
    const Triangle& t = triangles[number];
    boxes.push_back(box_of(points[t[0]], points[t[1]], points[t[2]]));
  }
  return boxes;
}

}  // namespace

Sight::Sight(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
             const Marks& left_out)
    : triangles_(triangles),
      points_(points),
      triangle_in_(all_but(left_out)),
      boxes_(boxes_of(triangles, points, triangle_in_)),
      tree_(boxes_, BoxTree::Division::kCurve) {
  if (boxes_.empty()) return;
  Box all = boxes_[0];
  for (const Box& box : boxes_) grow(all, box);
  least_distance_ = kOverlooked * (all.max - all.min).norm();
}

bool Sight::escapes(const Vec3& origin, const Vec3& direction, TriangleId from) const {
  const ShearedRay ray(origin, direction);
  return !tree_.any_along(origin, direction, [&](Index i) {
    const Triangle& t = triangles_[triangle_in_[i]];
    return triangle_in_[i] != from &&
           ray.crossing(points_[t[0]], points_[t[1]], points_[t[2]], least_distance_) != 0;
  });
}

int Sight::winding(const Vec3& origin, const Vec3& direction, TriangleId from) const {
  const ShearedRay ray(origin, direction);
  int winding = 0;
  tree_.any_along(origin, direction, [&](Index i) {
    const Triangle& t = triangles_[triangle_in_[i]];
    if (triangle_in_[i] == from) return false;
    winding += ray.crossing(points_[t[0]], points_[t[1]], points_[t[2]], least_distance_);
    return false;
  });
  return winding;
}

// Takes points of a cube, from a linear congruential generator, that lie within the unit sphere.
std::vector<Vec3> spread_directions(Index count) {
  std::uint64_t state = 0x9e3779b97f4a7c15u;
  const auto coordinate = [&] {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state >> 40) / (1 << 23) - 1 + 0x1p-25;
  };
  std::vector<Vec3> directions;
  while (directions.size() < count) {
    const double x = coordinate();
    const double y = coordinate();
    const double z = coordinate();
    const Vec3 p(x, y, z);
    const double square = p.squaredNorm();
    if (square <= 1 && square > 0.01) directions.emplace_back(p / std::sqrt(square));
  }
  return directions;
}

}  // namespace kdm
