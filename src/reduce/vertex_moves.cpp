// SPDX-License-Identifier: MIT
// Tries the middle of the neighbours and the vertex itself, each in the plane of the reference's
// nearest triangle, and half the way to the former.
#include "reduce/vertex_moves.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/triangle.h"
#include "reduce/near_test.h"
#include "reduce/shape.h"

namespace kdm {
namespace {

// Cosine of some 57 degrees: between triangles that lie so far apart, a smooth surface turns by
// less.
constexpr double kSteep = 0.55;

bool is_on_line(const Workpiece& piece, VertexId v) {
  if (piece.mesh.on_boundary(v)) return true;
  bool found = false;
  piece.mesh.for_each_leaving(v, [&](SideId h) { found = found || piece.is_border(h); });
  return found;
}

// Returns the vertex's triangles with its point elsewhere.
CollapseRing ring_at(const Workpiece& piece, VertexId v, const Vec3& point) {
  CollapseRing ring{v, v, point, {}, {}};
  piece.mesh.for_each_leaving(v, [&](SideId h) {
    const VertexId from = piece.mesh.end(h);
    const VertexId to = piece.mesh.start(previous_side(h));
    const SideId beyond = piece.mesh.opposite(next_side(h));
    ring.triangles.push_back({triangle_of(h), from, to,
                              beyond == kNone ? kNone : triangle_of(beyond), piece.positions[from],
                              piece.positions[to], piece.positions[v],
                              piece.faces[triangle_of(h)]});
  });
  put_vertex(ring, point);
  return ring;
}

bool keeps_shape(const CollapseRing& ring) {
  return std::all_of(ring.triangles.begin(), ring.triangles.end(), [](const RingTriangle& t) {
    return t.before.normal.dot(t.after.normal) > 0 && t.after.shape >= kLeastShape;
  });
}

// Returns the point in the plane of the reference's triangle nearest to it.
Vec3 on_reference(const KeptDistance& kept, const Vec3& p, TriangleId hint) {
  const TriangleId nearest = kept.reference->nearest(p, kForeign * kept.error, hint);
  if (nearest == kNone) return p;
  const std::array<Vec3, 3>& c = kept.reference->corners(nearest);
  const Vec3 normal = unit_normal(c[0], c[1], c[2]);
  return p - normal.dot(p - c[0]) * normal;
}

}  // namespace

bool turns_in_reference(const Workpiece& piece, SideId edge) {
  const KeptDistance& kept = *piece.distance;
  std::array<Vec3, 2> normals;
  for (int i = 0; i < 2; ++i) {
    const SideId side = i == 0 ? edge : piece.mesh.opposite(edge);
    const Triangle c = piece.mesh.corners(triangle_of(side));
    const Vec3 middle = (piece.positions[c[0]] + piece.positions[c[1]] + piece.positions[c[2]]) / 3;
    const TriangleId nearest =
        kept.reference->nearest(middle, kForeign * kept.error, kept.near[c[0]]);
    if (nearest == kNone) return true;
    const std::array<Vec3, 3>& t = kept.reference->corners(nearest);
    normals[i] = unit_normal(t[0], t[1], t[2]);
  }
  return std::abs(normals[0].dot(normals[1])) < kSteep;
}

VertexMove move_to_smooth(Workpiece& piece, SmoothTest& smooth, CrossingGuard::Scratch& crossing,
                          VertexId v) {
  if (is_on_line(piece, v) || piece.is_held(v)) return VertexMove::kNever;
  KeptDistance& kept = *piece.distance;
  const Vec3 place = piece.positions[v];
  CollapseRing ring = ring_at(piece, v, place);
  Vec3 middle = Vec3::Zero();
  for (const RingTriangle& t : ring.triangles) middle += t.from_point;
  middle /= static_cast<double>(ring.triangles.size());
  const Vec3 centre = on_reference(kept, middle, kept.near[v]);
  // What is known near the vertex decides between planes that are equally near.
  const TriangleId near_before = kept.near[v];
  bool may_meet = false;
  NearFind found;
  for (const Vec3& point :
       {centre, on_reference(kept, place, kept.near[v]), Vec3(0.5 * (place + centre))}) {
    put_vertex(ring, point.cast<float>().cast<double>());
    if (!piece.may_hold(ring.point) || !smooth.smooths(ring) || !keeps_shape(ring)) continue;
    const bool near = stays_near(piece, ring, found);
    kept.near[v] = found.near;
    if (!near) continue;
    if (piece.guard->would_meet(ring, crossing)) {
      may_meet = true;
      continue;
    }
    kept.samples.move(ring, found.places);
    piece.positions[v] = ring.point;
    for (const RingTriangle& t : ring.triangles) piece.changed(t.number);
    return VertexMove::kMade;
  }
  return may_meet || kept.near[v] != near_before ? VertexMove::kNotNow : VertexMove::kNever;
}

}  // namespace kdm
