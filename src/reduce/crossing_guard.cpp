// SPDX-License-Identifier: MIT
// Finds what is near in a tree of boxes and decides by exact predicates.
#include "reduce/crossing_guard.h"

#include <algorithm>

#include "geometry/triangle.h"
#include "geometry/triangle_triangle.h"

namespace kdm {
namespace {

using Crossing = TriangleCrossing<RealKernel>;

// A tree with more triangles taken out than left is built anew.
constexpr double kWorn = 0.5;

// Far more than what rounding does to a few products and differences.
constexpr double kRounding = 1e-14;

double one_norm(const Vec3& v) { return v.cwiseAbs().sum(); }

// Returns the box round a triangle, an empty one if it was removed.
SmallBox box_of(const HalfEdges& mesh, const std::vector<Vec3>& positions, TriangleId t) {
  if (mesh.is_removed(t)) return {};
  const Triangle c = mesh.corners(t);
  return small_box(positions[c[0]], positions[c[1]], positions[c[2]]);
}

std::vector<SmallBox> boxes_of(const HalfEdges& mesh, const std::vector<Vec3>& positions) {
  std::vector<SmallBox> boxes(mesh.triangles());
  for (TriangleId t = 0; t < mesh.triangles(); ++t) boxes[t] = box_of(mesh, positions, t);
  return boxes;
}

}  // namespace

CrossingGuard::CrossingGuard(const HalfEdges& mesh, const std::vector<Vec3>& positions)
    : mesh_(mesh),
      positions_(positions),
      tree_(boxes_of(mesh, positions)),
      is_put_off_(mesh.triangles()),
      rebuild_below_(static_cast<Index>(kWorn * mesh.triangles())) {}

void CrossingGuard::Scratch::plan(const Triangle& numbers, const std::array<Vec3, 3>& corners) {
  planned_.push_back({numbers, corners, small_box(corners[0], corners[1], corners[2]),
                      doubled_area_vector(corners[0], corners[1], corners[2])});
}

// Tells whether the corners of the other triangle that are not shared surely lie beyond a plane.
// `size` is the size of the numbers that its normal is the difference of.
bool CrossingGuard::surely_beyond(const Planned& t, const Vec3& normal, double size,
                                  const Vec3& origin, const Triangle& other) const {
  for (const VertexId v : other) {
    if (v == t.numbers[0] || v == t.numbers[1] || v == t.numbers[2]) continue;
    const Vec3 off = positions_[v] - origin;
    if (!(normal.dot(off) > kRounding * size * one_norm(off))) return false;
  }
  return true;
}

// Tells whether the other triangle surely lies beyond the plane of a planned one, or beyond that
// through one of its sides that is perpendicular to it, apart from corners that are shared.
bool CrossingGuard::surely_beside(const Planned& t, const Triangle& other) const {
  const Vec3 first = t.corners[1] - t.corners[0];
  const Vec3 second = t.corners[2] - t.corners[0];
  const double size = one_norm(first) * one_norm(second);
  if (surely_beyond(t, t.doubled_area, size, t.corners[0], other) ||
      surely_beyond(t, -t.doubled_area, size, t.corners[0], other)) {
    return true;
  }
  for (int i = 0; i < 3; ++i) {
    // From the corner across, which lies on this side of the plane, the other triangle could lead
    // through this one.
    const VertexId across = t.numbers[next_corner(next_corner(i))];
    if (across == other[0] || across == other[1] || across == other[2]) continue;
    const Vec3 side = t.corners[next_corner(i)] - t.corners[i];
    if (surely_beyond(t, side.cross(t.doubled_area), one_norm(side) * size, t.corners[i], other)) {
      return true;
    }
  }
  return false;
}

bool CrossingGuard::meets(const Planned& triangle, TriangleId other) const {
  const Triangle numbers = mesh_.corners(other);
  if (surely_beside(triangle, numbers)) return false;
  return Crossing::test(triangle.corners, triangle.numbers,
                        {positions_[numbers[0]], positions_[numbers[1]], positions_[numbers[2]]},
                        numbers);
}

// Tells whether the planned triangle shares a vertex with another one round which nothing meets.
bool CrossingGuard::Scratch::surely_apart(const Planned& t, const Triangle& other) const {
  for (const VertexId v : other) {
    if (simple_.test(v) && (t.numbers[1] == v || t.numbers[2] == v)) return true;
  }
  return false;
}

// Tells whether the planned triangles meet each other or others; `beside` is one near to them.
// Those round a vertex that is marked simple need no test against each other.
bool CrossingGuard::planned_meet(const Scratch& scratch, bool simple_inside, TriangleId beside) {
  catch_up();
  const std::vector<Planned>& planned = scratch.planned_;
  SmallBox all;
  for (std::size_t i = 0; i < planned.size(); ++i) {
    const Planned& t = planned[i];
    if (!has_area(t.corners[0], t.corners[1], t.corners[2])) return true;
    for (std::size_t j = 0; j < i && !simple_inside; ++j) {
      if (Crossing::test(t.corners, t.numbers, planned[j].corners, planned[j].numbers)) {
        return true;
      }
    }
    all.grow(t.box);
  }
  return tree_.any_meeting(all, beside, [&](TriangleId other) {
    if (scratch.replaced_.test(other)) return false;
    const SmallBox box = tree_.box(other);
    const Triangle corners = mesh_.corners(other);
    for (const Planned& t : planned) {
      if (t.box.meets(box) && !scratch.surely_apart(t, corners) && meets(t, other)) return true;
    }
    return false;
  });
}

// Looks at the triangles round the new vertex.
bool CrossingGuard::is_simple(const CollapseRing& ring, Scratch& scratch) const {
  if (mesh_.on_boundary(ring.kept) || mesh_.on_boundary(ring.removed)) return false;
  scratch.sides_.clear();
  for (const RingTriangle& t : ring.triangles) {
    scratch.sides_.emplace_back(t.from_point - ring.point, t.to_point - ring.point);
  }
  return is_simple_fan(scratch.sides_);
}

// Looks at the triangles round a vertex of the ring as they would be.
bool CrossingGuard::is_simple(const CollapseRing& ring, VertexId v, Scratch& scratch) const {
  if (mesh_.on_boundary(v)) return false;
  scratch.sides_.clear();
  const Vec3& apex = positions_[v];
  const auto point = [&](VertexId w) -> const Vec3& {
    return w == ring.kept || w == ring.removed ? ring.point : positions_[w];
  };
  mesh_.for_each_leaving(v, [&](SideId h) {
    const TriangleId t = triangle_of(h);
    if (std::find(ring.gone.begin(), ring.gone.end(), t) != ring.gone.end()) return;
    scratch.sides_.emplace_back(point(mesh_.end(h)) - apex,
                                point(mesh_.start(previous_side(h))) - apex);
  });
  return is_simple_fan(scratch.sides_);
}

bool CrossingGuard::is_simple_all_round(const CollapseRing& ring, Scratch& scratch) const {
  return is_simple(ring, scratch) &&
         std::all_of(ring.triangles.begin(), ring.triangles.end(),
                     [&](const RingTriangle& t) { return is_simple(ring, t.from, scratch); });
}

bool CrossingGuard::would_meet(const CollapseRing& ring, Scratch& scratch) {
  Marks& replaced = scratch.replaced_;
  Marks& simple = scratch.simple_;
  scratch.planned_.clear();
  for (const RingTriangle& t : ring.triangles) {
    scratch.plan(numbers_of(ring, t), corners_of(ring, t));
    replaced.set(t.number);
  }
  for (const TriangleId t : ring.gone) replaced.set(t);
  for (const RingTriangle& t : ring.triangles) {
    if (is_simple(ring, t.from, scratch)) simple.set(t.from);
  }
  const bool meet = planned_meet(scratch, is_simple(ring, scratch), ring.triangles.front().number);
  for (const RingTriangle& t : ring.triangles) {
    replaced.clear(t.number);
    simple.clear(t.from);
  }
  for (const TriangleId t : ring.gone) replaced.clear(t);
  return meet;
}

bool CrossingGuard::would_meet(const std::array<TriangleId, 2>& places,
                               const std::array<Triangle, 2>& triangles, Scratch& scratch) {
  scratch.planned_.clear();
  for (const Triangle& t : triangles) {
    scratch.plan(t, {positions_[t[0]], positions_[t[1]], positions_[t[2]]});
  }
  for (const TriangleId t : places) scratch.replaced_.set(t);
  const bool meet = planned_meet(scratch, false, places.front());
  for (const TriangleId t : places) scratch.replaced_.clear(t);
  return meet;
}

// Many triangles change several times before the tree is asked again.
void CrossingGuard::changed(TriangleId t) {
  if (!is_put_off_.test_and_set(t)) put_off_.push_back(t);
}

void CrossingGuard::catch_up() {
  if (put_off_.empty()) return;
  for (const TriangleId t : put_off_) {
    is_put_off_.clear(t);
    tree_.change(t, box_of(mesh_, positions_, t));
  }
  put_off_.clear();
  if (mesh_.living_triangles() >= rebuild_below_) return;
  tree_.rebuild();
  rebuild_below_ = static_cast<Index>(kWorn * mesh_.living_triangles());
}

}  // namespace kdm
