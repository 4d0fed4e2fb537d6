// SPDX-License-Identifier: MIT
// Follows a ray from the front of each of some points and counts how often it leaves the surface.
#include "prepare/outside_in.h"

#include <algorithm>
#include <cmath>

#include "geometry/triangle.h"
#include "prepare/sight.h"

namespace kdm {
namespace {

constexpr int kSamples = 128;

double fraction(double x) { return x - std::floor(x); }

}  // namespace

double share_outside_in(std::span<const Triangle> triangles, Index counted,
                        const std::vector<Vec3>& points) {
  const auto area_vector = [&](const Triangle& t) {
    return doubled_area_vector(points[t[0]], points[t[1]], points[t[2]]);
  };
  std::vector<double> area_up_to;
  double area = 0;
  for (TriangleId t = 0; t < counted; ++t) {
    area_up_to.push_back(area += area_vector(triangles[t]).norm());
  }
  if (!(area > 0)) return 0;
  const Sight sight(triangles, points, Marks(triangles.size()));
  const std::vector<Vec3> directions = spread_directions(kSamples);
  int negative = 0;
  for (int i = 0; i < kSamples; ++i) {
    const auto found =
        std::upper_bound(area_up_to.begin(), area_up_to.end(), (i + 0.5) / kSamples * area);
    const auto number = static_cast<TriangleId>(
        std::min<std::ptrdiff_t>(found - area_up_to.begin(), counted - std::ptrdiff_t{1}));
    const Triangle& t = triangles[number];
    // Multiples of the powers of the inverse plastic number fill a square evenly.
    double u = fraction(0.7548776662466927 * i);
    double v = fraction(0.5698402909980532 * i);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const Vec3& corner = points[t[0]];
    const Vec3 origin = corner + u * (points[t[1]] - corner) + v * (points[t[2]] - corner);
    const Vec3 direction =
        normalized_or_zero(area_vector(t)) + directions[static_cast<std::size_t>(i)];
    if (direction.cwiseAbs().minCoeff() == 0) continue;
    negative += sight.winding(origin, direction, number) < 0 ? 1 : 0;
  }
  return negative / static_cast<double>(kSamples);
}

}  // namespace kdm
