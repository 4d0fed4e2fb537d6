// SPDX-License-Identifier: MIT
// Finds points at which an edge of the mesh may pass through the minimal face of its link.
#include "extract/place/link_point.h"

#include <cmath>

#include "geometry/quadric.h"

namespace kdm {
namespace {

// Planes whose normals turn by more than 45 degrees make a sharp edge.
constexpr double kSharpCosine = 0.7071067811865476;
// A hit so near to a plane lies on it, in lattice units: corners of the input are rounded to the
// lattice, so planes that coincided come to be twice the root of 3/4 apart.
constexpr double kOnPlane = 2;

bool contains(const LinkFace& face, const Vec3& p) {
  return (p.array() >= face.lo.array()).all() && (p.array() <= face.hi.array()).all();
}

// Tells whether the point, which must lie in the face, lies on one of the face's sides.
bool on_side(const LinkFace& face, const Vec3& p) {
  for (int i = 0; i < 3; ++i) {
    if (i != face.axis && (p[i] == face.lo[i] || p[i] == face.hi[i])) return true;
  }
  return false;
}

// Returns 1 where each hit lies behind the plane of the other one, as on a convex edge, -1 where
// each lies in front, and 0 where the surface is flat or bends both ways between them.
int convexity(const GridView& view, HitPair link) {
  const double first = view.grid.plane_of(link.other).signed_distance(view.hit_points[link.hit]);
  const double second = view.grid.plane_of(link.hit).signed_distance(view.hit_points[link.other]);
  if (!(first * second > 0)) return 0;
  return first < 0 ? 1 : -1;
}

// Tells whether the planes of the two hits make a sharp edge that lies between the hits.
bool is_sharp(const GridView& view, HitPair link) {
  const double cosine =
      view.grid.plane_of(link.hit).normal.dot(view.grid.plane_of(link.other).normal);
  return cosine < kSharpCosine && convexity(view, link) != 0;
}

}  // namespace

Vec3 chord_point(const GridView& view, const LinkFace& face, HitPair link,
                 const std::vector<HitPair>& links) {
  return lift_off_side(view, face, link, links,
                       0.5 * (view.hit_points[link.hit] + view.hit_points[link.other]));
}

Vec3 behind_planes(const GridView& view, HitPair link, std::span<const Index> hits, double distance,
                   const Vec3& crease) {
  const int outwards = convexity(view, link);
  if (outwards == 0) return crease;
  const Vec3& p = view.hit_points[link.hit];
  const Vec3& q = view.hit_points[link.other];
  const Vec3 middle = 0.5 * (p + q);
  double furthest = distance;
  Vec3 point = crease;
  for (const Index hit : hits) {
    const Plane& plane = view.grid.plane_of(hit);
    const auto beyond = [&](const Vec3& x) { return outwards * plane.signed_distance(x); };
    const double off = beyond(crease);
    if (off <= furthest || beyond(p) >= -kOnPlane || beyond(q) >= -kOnPlane) continue;
    furthest = off;
    point = crease + off / (off - beyond(middle)) * (middle - crease);
  }
  return point;
}

Vec3 crease_point(const GridView& view, const LinkFace& face, HitPair link,
                  std::span<const Index> hits, double distance) {
  const Vec3 middle = 0.5 * (view.hit_points[link.hit] + view.hit_points[link.other]);
  PrimalQuadric quadric(middle);
  quadric.add(view.grid.plane_of(link.hit));
  quadric.add(view.grid.plane_of(link.other));
  if (is_sharp(view, link)) {
    // Where an edge lies outside of the face, a third plane may still cut it off within.
    Vec3 around = Vec3::Constant(kLatticeSize);
    around[face.axis] = 0;
    const Vec3 edge = quadric.minimiser_in(face.lo - around, face.hi + around);
    const Vec3 cut = behind_planes(view, link, hits, distance, edge);
    if (cut != edge && contains(face, cut)) return lift_off_side(view, face, link, {}, cut);
  }
  Vec3 crease = quadric.minimiser_in(face.lo, face.hi);
  // Beyond both the hits and the face the planes of no sharp edge say nothing: the surface is
  // curved, or bends both ways.
  const Vec3 chord = view.hit_points[link.other] - view.hit_points[link.hit];
  const bool beyond = std::abs(chord.dot(crease - middle)) > 0.5 * chord.squaredNorm();
  if (beyond && on_side(face, crease) && !is_sharp(view, link)) crease = middle;
  crease = behind_planes(view, link, hits, distance, crease);
  return lift_off_side(view, face, link, {}, crease);
}

}  // namespace kdm
