// SPDX-License-Identifier: MIT
// Compares the planes round each mesh vertex with the first of them.
#include "prepare/crease_vertices.h"

#include <algorithm>
#include <utility>

#include "mesh/marks.h"

namespace kdm {

CreaseVertices::CreaseVertices(const Surface& surface, std::span<const Plane> planes,
                               double half_angle_cosine) {
  PointId last = 0;
  for (const Triangle& t : surface.corners) last = std::max({last, t[0], t[1], t[2]});
  std::vector<TriangleId> first_triangle(std::size_t{last} + 1, kNone);  // per point
  Marks on_crease(first_triangle.size());
  const auto for_each_corner = [&](const auto& visit) {
    for (TriangleId t = 0; t < surface.triangles.size(); ++t) {
      if (surface.degenerate.test(t)) continue;
      for (int i = 0; i < 3; ++i) visit(surface.corners[t][i], t, i);
    }
  };
  // If two planes at a vertex differ by an angle, one of them differs from the first plane there by
  // half the angle at least.
  for_each_corner([&](PointId point, TriangleId t, int i) {
    if (first_triangle[point] == kNone) first_triangle[point] = t;
    if (on_crease.test(point)) return;
    if (planes[t].normal.dot(planes[first_triangle[point]].normal) >= half_angle_cosine) return;
    on_crease.set(point);
    all_.push_back({point, surface.triangles[t][i]});
  });
  if (all_.empty()) return;
  std::vector<std::pair<PointId, TriangleId>> round;
  for_each_corner([&](PointId point, TriangleId t, int) {
    if (on_crease.test(point)) round.emplace_back(point, t);
  });
  triangles_round_ = Groups(first_triangle.size(), [&](const auto& put) {
    for (const auto& [point, t] : round) put(point, t);
  });
}

}  // namespace kdm
