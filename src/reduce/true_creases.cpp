// SPDX-License-Identifier: MIT
// Triangles are neighbours if they have two corners in the same places: the reference may be a
// soup.
#include "reduce/true_creases.h"

#include <cmath>

#include "geometry/distance.h"
#include "geometry/triangle.h"

namespace kdm {
namespace {

constexpr double kCreaseCosine = 0.9659258262890683;  // of 15 degrees

Vec3 unit_normal(const std::array<Vec3, 3>& t) {
  return normalized_or_zero(doubled_area_vector(t[0], t[1], t[2]));
}

bool has_corner(const std::array<Vec3, 3>& t, const Vec3& p) {
  return t[0] == p || t[1] == p || t[2] == p;
}

}  // namespace

bool TrueCreases::are_near(const Vec3& p) {
  const double limit = reach_ * reach_;
  return reference_.tree().any_meeting(small_box(p, reach_), [&](TriangleId t) {
    const std::array<Vec3, 3>& c = reference_.corners(t);
    for (int i = 0; i < 3; ++i) {
      if (squared_distance(p, c[i], c[(i + 1) % 3]) <= limit && is_crease(t, i)) return true;
    }
    return false;
  });
}

bool TrueCreases::is_crease(TriangleId t, int corner) {
  Side& side = sides_[3 * std::size_t{t} + static_cast<std::size_t>(corner)];
  if (side == Side::kUnknown) side = find_out(t, corner) ? Side::kCrease : Side::kSmooth;
  return side == Side::kCrease;
}

// Neighbours may be turned against each other.
bool TrueCreases::find_out(TriangleId t, int corner) const {
  const std::array<Vec3, 3>& c = reference_.corners(t);
  const Vec3& from = c[corner];
  const Vec3& to = c[(corner + 1) % 3];
  const Vec3 normal = unit_normal(c);
  SmallBox middle;
  middle.grow(Vec3(0.5 * (from + to)));
  return reference_.tree().any_meeting(middle, [&](TriangleId other) {
    const std::array<Vec3, 3>& o = reference_.corners(other);
    return other != t && has_corner(o, from) && has_corner(o, to) &&
           std::abs(normal.dot(unit_normal(o))) < kCreaseCosine;
  });
}

}  // namespace kdm
