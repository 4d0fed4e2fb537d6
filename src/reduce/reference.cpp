// SPDX-License-Identifier: MIT
// Looks the triangles up in a tree.
#include "reduce/reference.h"

#include "geometry/distance.h"

namespace kdm {
namespace {

std::vector<SmallBox> boxes_of(const std::vector<std::array<Vec3, 3>>& triangles) {
  std::vector<SmallBox> boxes;
  boxes.reserve(triangles.size());
  for (const std::array<Vec3, 3>& t : triangles) boxes.push_back(small_box(t[0], t[1], t[2]));
  return boxes;
}

}  // namespace

Reference::Reference(std::vector<std::array<Vec3, 3>> triangles)
    : triangles_(std::move(triangles)), tree_(boxes_of(triangles_)) {}

double Reference::squared_distance(TriangleId t, const Vec3& p) const {
  const std::array<Vec3, 3>& corners = triangles_[t];
  return kdm::squared_distance(p, corners[0], corners[1], corners[2]);
}

bool Reference::is_near(const Vec3& p, double distance, TriangleId& hint) const {
  const double enough = distance * distance;
  if (hint != kNone && squared_distance(hint, p) <= enough) return true;
  return tree_.any_meeting(small_box(p, distance), hint, [&](TriangleId t) {
    if (squared_distance(t, p) > enough) return false;
    hint = t;
    return true;
  });
}

TriangleId Reference::nearest(const Vec3& p, double distance, TriangleId hint,
                              double enough) const {
  return tree_.nearest(p, distance * distance, enough * enough, hint,
                       [&](TriangleId t) { return squared_distance(t, p); });
}

}  // namespace kdm
