// SPDX-License-Identifier: MIT
// Follows rays from both sides of some points and counts how often they leave the surface.
#include "prepare/outside_in.h"

#include <algorithm>
#include <cmath>

#include "geometry/triangle.h"

namespace kdm {
namespace {

double fraction(double x) { return x - std::floor(x); }

bool is_direction(const Vec3& v) { return v.cwiseAbs().minCoeff() > 0; }

// Which points of a surface are counted.
enum class Points { kOutsideIn, kBounding };

// Returns the share of points spread evenly over the counted triangles that are of that kind.
double share_of(Points kind, std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                const Sight& sight, std::span<const TriangleId> counted, Index samples) {
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
    const Vec3 normal = normalized_or_zero(area_vector(t));
    const Vec3 forwards = normal + directions[i];
    const Vec3 backwards = directions[i] - normal;
    if (!is_direction(forwards)) continue;
    if (kind == Points::kOutsideIn) {
      if (sight.winding(origin, forwards, number) < 0) ++found;
    } else if (is_direction(backwards) && sight.winding(origin, forwards, number) <= 0 &&
               sight.winding(origin, backwards, number) > 0) {
      ++found;
    }
  }
  return found / static_cast<double>(samples);
}

}  // namespace

double share_outside_in(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                        const Sight& sight, std::span<const TriangleId> counted, Index samples) {
  return share_of(Points::kOutsideIn, triangles, points, sight, counted, samples);
}

double share_that_bounds(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                         const Sight& sight, std::span<const TriangleId> counted, Index samples) {
  return share_of(Points::kBounding, triangles, points, sight, counted, samples);
}

}  // namespace kdm
