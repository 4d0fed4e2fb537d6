// SPDX-License-Identifier: MIT
// Follows rays from both sides of some points and counts how often they leave the surface.
#include "prepare/outside_in.h"

#include <algorithm>
#include <cmath>

#include "geometry/triangle.h"

namespace kdm {
namespace {

double fraction(double x) { return x - std::floor(x); }

// Calls `test(origin, normal, deviation, triangle)` for points spread evenly over the counted
// triangles, and returns the share for which it is true. `normal` plus or minus `deviation` are
// directions that lead away from the triangle.
template <typename Test>
double share_of_points(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                       std::span<const TriangleId> counted, Index samples, const Test& test) {
  const auto area_vector = [&](const Triangle& t) {
    return doubled_area_vector(points[t[0]], points[t[1]], points[t[2]]);
  };
  std::vector<double> area_up_to;
  double area = 0;
  for (const TriangleId t : counted) {
    area_up_to.push_back(area += area_vector(triangles[t]).norm());
  }
  if (!(area > 0)) return 0;
  const std::vector<Vec3> directions = spread_directions(samples);
  Index found = 0;
  for (Index i = 0; i < samples; ++i) {
    const auto at =
        std::upper_bound(area_up_to.begin(), area_up_to.end(), (i + 0.5) / samples * area);
    const auto place = static_cast<std::size_t>(at - area_up_to.begin());
    const TriangleId number = counted[std::min(place, counted.size() - 1)];
    const Triangle& t = triangles[number];
    // Multiples of the powers of the inverse plastic number fill a square evenly.
    double u = fraction(0.7548776662466927 * (i + 1));
    double v = fraction(0.5698402909980532 * (i + 1));
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const Vec3& corner = points[t[0]];
    const Vec3 origin = corner + u * (points[t[1]] - corner) + v * (points[t[2]] - corner);
    if (test(origin, normalized_or_zero(area_vector(t)), directions[i], number)) ++found;
  }
  return found / static_cast<double>(samples);
}

bool is_direction(const Vec3& v) { return v.cwiseAbs().minCoeff() > 0; }

}  // namespace

double share_outside_in(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                        const Sight& sight, std::span<const TriangleId> counted, Index samples) {
  return share_of_points(
      triangles, points, counted, samples,
      [&](const Vec3& origin, const Vec3& normal, const Vec3& deviation, TriangleId from) {
        const Vec3 forwards = normal + deviation;
        return is_direction(forwards) && sight.winding(origin, forwards, from) < 0;
      });
}

double share_that_bounds(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                         const Sight& sight, std::span<const TriangleId> counted, Index samples) {
  return share_of_points(
      triangles, points, counted, samples,
      [&](const Vec3& origin, const Vec3& normal, const Vec3& deviation, TriangleId from) {
        const Vec3 forwards = normal + deviation;
        const Vec3 backwards = deviation - normal;
        return is_direction(forwards) && is_direction(backwards) &&
               sight.winding(origin, forwards, from) <= 0 &&
               sight.winding(origin, backwards, from) > 0;
      });
}

}  // namespace kdm
