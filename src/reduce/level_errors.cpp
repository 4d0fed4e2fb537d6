// SPDX-License-Identifier: MIT
// Looks points of one surface up on the other. Of vertices it is enough to know that they are no
// further than a point before.
#include "reduce/level_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/triangle.h"
#include "mesh/spread.h"

namespace kdm {
namespace {

constexpr double kPoints = 4096;
constexpr double kUnlimited = std::numeric_limits<double>::infinity();

double area_of(const std::array<Vec3, 3>& t) {
  return doubled_area_vector(t[0], t[1], t[2]).norm() / 2;
}

Reference surface_of(const Mesh& mesh) {
  std::vector<std::array<Vec3, 3>> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    triangles.push_back({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]});
  }
  return Reference(std::move(triangles));
}

// Calls visit(p, for_mean) for the points of a surface: first those spread over its area, then the
// corners of its triangles.
template <typename Visit>
void for_each_point(const Reference& surface, const Visit& visit) {
  double area = 0;
  for (TriangleId t = 0; t < surface.size(); ++t) area += area_of(surface.corners(t));
  if (!(area > 0)) return;
  Spread spread(area / kPoints);
  for (TriangleId t = 0; t < surface.size(); ++t) {
    const std::array<Vec3, 3>& c = surface.corners(t);
    spread.for_each_point(c[0], c[1], c[2], area_of(c), [&](const Vec3& p) { visit(p, true); });
  }
  for (TriangleId t = 0; t < surface.size(); ++t) {
    for (const Vec3& corner : surface.corners(t)) visit(corner, false);
  }
}

// Gathers how far points are from a surface.
class Distances {
 public:
  explicit Distances(const Reference& to) : to_(to) {}

  void add(const Vec3& p, bool for_mean) {
    if (!for_mean && to_.is_near(p, largest_, hint_)) return;
    hint_ = to_.nearest(p, kAnyDistance, hint_);
    const double squared = hint_ == kNone ? kUnlimited : to_.squared_distance(hint_, p);
    largest_ = std::max(largest_, std::sqrt(squared));
    if (!for_mean) return;
    sum_ += squared;
    ++in_mean_;
  }
  Deviation deviation() const {
    if (in_mean_ == 0) return {kUnlimited, kUnlimited};
    return {largest_, std::sqrt(sum_ / in_mean_)};
  }

 private:
  static constexpr double kAnyDistance = 1e100;

  const Reference& to_;
  TriangleId hint_ = kNone;
  double largest_ = 0;
  double sum_ = 0;
  Index in_mean_ = 0;
};

}  // namespace

LevelErrors::LevelErrors(const Reference& reference, const Reference& surface, double reach)
    : reference_(reference) {
  TriangleId hint = kNone;
  for_each_point(reference, [&](const Vec3& p, bool for_mean) {
    // The next corner is often the same again.
    if (!points_.empty() && p == points_.back().place) return;
    if (surface.is_near(p, reach, hint)) points_.push_back({p, for_mean});
  });
}

MeshError LevelErrors::of(const Mesh& level) const {
  const Reference surface = surface_of(level);
  Distances to_input(reference_);
  Distances to_output(surface);
  for_each_point(surface, [&](const Vec3& p, bool for_mean) { to_input.add(p, for_mean); });
  for (const Point& p : points_) to_output.add(p.place, p.for_mean);
  return {.to_input = to_input.deviation(), .to_output = to_output.deviation()};
}

}  // namespace kdm
