// SPDX-License-Identifier: MIT
// Mesh vertices at which the surface bends.
#include "prepare/bends.h"

#include <algorithm>

namespace kdm {

Bends::Bends(const Surface& surface, std::span<const Plane> planes, double cosine_of_half) {
  Index last = 0;
  for (const Triangle& t : surface.corners) last = std::max({last, t[0], t[1], t[2]});
  std::vector<Index> first(std::size_t{last} + 1, kNone);  // per point: the first triangle
  std::vector<char> bent(first.size(), 0);
  const auto for_each_corner = [&](const auto& visit) {
    for (Index t = 0; t < surface.triangles.size(); ++t) {
      if (surface.degenerate[t] != 0) continue;
      for (int i = 0; i < 3; ++i) visit(surface.corners[t][i], t, i);
    }
  };
  // Of two planes that differ by an angle, one differs from the first by half of it.
  for_each_corner([&](Index point, Index t, int i) {
    if (first[point] == kNone) first[point] = t;
    if (bent[point] != 0) return;
    if (planes[t].normal.dot(planes[first[point]].normal) >= cosine_of_half) return;
    bent[point] = 1;
    all_.push_back({point, surface.triangles[t][i]});
  });
  round_ = Groups(first.size(), [&](const auto& put) {
    for_each_corner([&](Index point, Index t, int) {
      if (bent[point] != 0) put(point, t);
    });
  });
}

}  // namespace kdm
