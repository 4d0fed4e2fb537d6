// SPDX-License-Identifier: MIT
// Compares normals.
#include "reduce/smooth_test.h"

#include <algorithm>
#include <array>

#include "geometry/triangle.h"

namespace kdm {
namespace {

// Cosine of 30 degrees: what turns by more looks like a crease. And what rounding may do to it.
constexpr double kSmooth = 0.8660254037844387;
constexpr double kCosineSlack = 1e-9;

}  // namespace

// Finds what turns by more than 30 degrees in the ring, now and then.
void SmoothTest::find_turns(const CollapseRing& ring) {
  before_.clear();
  after_.clear();
  const auto look = [&](std::vector<Turn>& turns, double cosine, const Vec3& p, const Vec3& q) {
    if (cosine < kSmooth) turns.push_back({cosine, 0.5 * (p + q)});
  };
  if (ring.gone.size() == 2) {
    look(before_, normal_of(ring.gone[0]).dot(normal_of(ring.gone[1])), piece_.positions[ring.kept],
         piece_.positions[ring.removed]);
  }
  for (const RingTriangle& t : ring.triangles) {
    if (t.beyond != kNone) {
      const Vec3& normal = normal_of(t.beyond);
      look(before_, normal.dot(t.before.normal), t.from_point, t.to_point);
      look(after_, normal.dot(t.after.normal), t.from_point, t.to_point);
    }
    for (const RingTriangle& next : ring.triangles) {
      if (next.from != t.to) continue;
      look(after_, t.after.normal.dot(next.after.normal), ring.point, t.to_point);
      if (t.old_point == next.old_point) {
        look(before_, t.before.normal.dot(next.before.normal), t.old_point, t.to_point);
        continue;
      }
      // At two ends of the edge, with one of the triangles beside it in between.
      for (const TriangleId gone : ring.gone) {
        const Triangle c = piece_.mesh.corners(gone);
        if (std::find(c.begin(), c.end(), t.to) == c.end()) continue;
        const Vec3& normal = normal_of(gone);
        look(before_, t.before.normal.dot(normal), t.old_point, t.to_point);
        look(before_, normal.dot(next.before.normal), next.old_point, t.to_point);
      }
    }
  }
}

std::ptrdiff_t SmoothTest::false_creases(const std::vector<Turn>& turns) const {
  return std::count_if(turns.begin(), turns.end(),
                       [&](const Turn& turn) { return !creases_.are_near(turn.middle); });
}

bool SmoothTest::stays_smooth(const CollapseRing& ring) {
  find_turns(ring);
  if (after_.empty()) return true;
  const std::ptrdiff_t after = false_creases(after_);
  return after == 0 || after < false_creases(before_);
}

bool SmoothTest::smooths(const CollapseRing& ring) {
  find_turns(ring);
  return false_creases(after_) < false_creases(before_);
}

bool SmoothTest::is_false_crease(SideId h) const {
  const HalfEdges& mesh = piece_.mesh;
  const SideId back = mesh.opposite(h);
  if (back == kNone || normal_of(triangle_of(h)).dot(normal_of(triangle_of(back))) >= kSmooth) {
    return false;
  }
  return !creases_.are_near(0.5 *
                            (piece_.positions[mesh.start(h)] + piece_.positions[mesh.end(h)]));
}

bool SmoothTest::flip_smooths(SideId h) const {
  const HalfEdges& mesh = piece_.mesh;
  const SideId back = mesh.opposite(h);
  const auto point = [&](SideId side) -> const Vec3& { return piece_.positions[mesh.start(side)]; };
  // Triangles (a, b, c) and (b, a, d) become (a, d, c) and (b, c, d).
  const Vec3& a = point(h);
  const Vec3& b = point(back);
  const Vec3& c = point(previous_side(h));
  const Vec3& d = point(previous_side(back));
  const std::array<Vec3, 2> before = {normal_of(triangle_of(h)), normal_of(triangle_of(back))};
  const std::array<Vec3, 2> after = {unit_normal(a, d, c), unit_normal(b, c, d)};
  double worst_before = before[0].dot(before[1]);
  double worst_after = after[0].dot(after[1]);
  const auto compare = [&](SideId side, int now, int then) {
    const SideId beyond = mesh.opposite(side);
    if (beyond == kNone) return;
    const Vec3 normal = normal_of(triangle_of(beyond));
    worst_before = std::min(worst_before, normal.dot(before[now]));
    worst_after = std::min(worst_after, normal.dot(after[then]));
  };
  compare(next_side(h), 0, 1);         // b to c
  compare(previous_side(h), 0, 0);     // c to a
  compare(next_side(back), 1, 0);      // a to d
  compare(previous_side(back), 1, 1);  // d to b
  return worst_after > worst_before + kCosineSlack;
}

}  // namespace kdm
