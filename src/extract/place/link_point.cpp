// SPDX-License-Identifier: MIT
// Where an edge of the mesh may pass through the minimal face of its link.
#include "extract/place/link_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "extract/dual/clearance.h"
#include "geometry/quadric.h"

namespace kdm {
namespace {

// How far an arc between hits of one edge leaves it, as a fraction of their distance.
constexpr double kArcHeight = 0.05;
// Where there is room, no less than this, lattice units.
constexpr double kSeen = 0.375;

// How far a vertex keeps off the sides of its face at most, as a fraction of the face's size.
constexpr double kPart = 1.0 / 64;

// Planes that meet at more than this (45 degrees) make a sharp edge.
constexpr double kSharpCosine = 0.7071067811865476;

bool holds(const LinkFace& face, const Vec3& p) {
  return (p.array() >= face.lo.array()).all() && (p.array() <= face.hi.array()).all();
}

// The side of the face that both hits lie on: its axis, or -1.
int common_side(const LinkFace& face, const Vec3& p, const Vec3& q) {
  for (int i = 0; i < 3; ++i) {
    if (i != face.axis && p[i] == q[i] && (p[i] == face.lo[i] || p[i] == face.hi[i])) return i;
  }
  return -1;
}

bool on_side(const LinkFace& face, const Vec3& p) {
  for (int i = 0; i < 3; ++i) {
    if (i != face.axis && (p[i] == face.lo[i] || p[i] == face.hi[i])) return true;
  }
  return false;
}

// Links of a face whose hits both lie on one of its sides, and what passes over them.
class Arcs {
 public:
  Arcs(std::span<const Vec3> hit_points, const LinkFace& face, int side, bool low)
      : hit_points_(hit_points),
        side_(side),
        along_(3 - side - face.axis),
        base_(low ? face.lo[side] : face.hi[side]),
        up_(low ? 1 : -1),
        width_(face.hi[side] - face.lo[side]),
        slope_(kArcHeight * std::min(1.0, width_ / (face.hi[along_] - face.lo[along_]))) {}

  // Longer ones come first: they pass over shorter ones.
  std::vector<HitPair> sorted(std::vector<HitPair> links) const {
    std::sort(links.begin(), links.end(), [&](const HitPair& a, const HitPair& b) {
      const double first = is_arc(a) ? length(a) : std::numeric_limits<double>::infinity();
      const double second = is_arc(b) ? length(b) : std::numeric_limits<double>::infinity();
      if (first != second) return first > second;
      return std::pair(a.hit, a.other) < std::pair(b.hit, b.other);
    });
    return links;
  }

  bool is_arc(const HitPair& link) const {
    return hit_points_[link.hit][side_] == base_ && hit_points_[link.other][side_] == base_;
  }

  double usual_height(const HitPair& link) const { return slope_ * length(link); }

  // How far the link leaves the side: by its length, but enough to be seen in 32 bits, and half as
  // far as those over it at most.
  double height(const HitPair& link) const {
    double limit = 2 * std::max(usual_height(link), std::min(kSeen, width_ / 4));
    for (const Line& line : lines_) limit = std::min(limit, least_over(line, link));
    return limit / 2;
  }

  // What is to pass over those that come later; `height` is an arc's.
  void add(const HitPair& link, double height) {
    const Vec3& p = hit_points_[link.hit];
    const Vec3& q = hit_points_[link.other];
    const double middle = is_arc(link) ? height : 0.5 * (above(p) + above(q));
    const double half = 0.5 * (p[along_] + q[along_]);
    lines_.push_back({{p[along_], half, q[along_]}, {above(p), middle, above(q)}});
  }

 private:
  struct Line {
    std::array<double, 3> along;
    std::array<double, 3> above;
  };

  double length(const HitPair& link) const {
    return std::abs(hit_points_[link.hit][along_] - hit_points_[link.other][along_]);
  }
  double above(const Vec3& p) const { return up_ * (p[side_] - base_); }

  // Between the arc's hits.
  double least_over(const Line& line, const HitPair& arc) const {
    const auto [lo, hi] = std::minmax(hit_points_[arc.hit][along_], hit_points_[arc.other][along_]);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 2; ++i) {
      const double from = line.along[i];
      const double to = line.along[i + 1];
      if (std::max(from, to) < lo || std::min(from, to) > hi) continue;
      for (const double x : {lo, hi}) {
        const double part = from == to ? 0 : std::clamp((x - from) / (to - from), 0.0, 1.0);
        least = std::min(least, line.above[i] + part * (line.above[i + 1] - line.above[i]));
      }
      if (from == to) least = std::min(least, line.above[i + 1]);
    }
    return least;
  }

  std::span<const Vec3> hit_points_;
  int side_;
  int along_;
  double base_;
  double up_;
  double width_;
  double slope_;
  std::vector<Line> lines_;
};

// The point; if both hits lie on a side of the face, a little off it at least.
Vec3 off_side(const GridView& view, const LinkFace& face, HitPair link,
              const std::vector<HitPair>& links, Vec3 point) {
  const int side = common_side(face, view.hit_points[link.hit], view.hit_points[link.other]);
  if (side < 0) return point;
  const bool low = view.hit_points[link.hit][side] == face.lo[side];
  Arcs arcs(view.hit_points, face, side, low);
  for (const HitPair& other : arcs.sorted(links)) {
    if (other.hit == link.hit || other.hit == link.other) break;
    arcs.add(other, arcs.is_arc(other) ? arcs.height(other) : 0);
  }
  const double height = links.empty() ? arcs.usual_height(link) : arcs.height(link);
  point[side] = low ? std::max(point[side], face.lo[side] + height)
                    : std::min(point[side], face.hi[side] - height);
  return point;
}

}  // namespace

std::optional<LinkFace> face_between(const LatticeBox& first, const LatticeBox& second) {
  LinkFace face{};
  int flat = 0;
  for (int i = 0; i < 3; ++i) {
    face.lo[i] = std::max(first.lo[i], second.lo[i]);
    face.hi[i] = std::min(first.hi[i], second.hi[i]);
    if (face.lo[i] < face.hi[i]) continue;
    face.axis = i;
    ++flat;
  }
  return flat == 1 ? std::optional(face) : std::nullopt;
}

Vec3 off_sides(const LinkFace& face, const Vec3& point, double margin) {
  const Vec3 off = (kPart * (face.hi - face.lo)).cwiseMin(margin);
  return point.cwiseMax(face.lo + off).cwiseMin(face.hi - off);
}

bool within(const LinkFace& face, const Vec3& point) {
  for (int i = 0; i < 3; ++i) {
    if (i == face.axis) continue;
    if (!(point[i] > face.lo[i] + kClear && point[i] < face.hi[i] - kClear)) return false;
  }
  return true;
}

Vec3 chord_point(const GridView& view, const LinkFace& face, HitPair link,
                 const std::vector<HitPair>& links) {
  return off_side(view, face, link, links,
                  0.5 * (view.hit_points[link.hit] + view.hit_points[link.other]));
}

namespace {

// 1 where both hits lie behind each other's plane, as on a convex edge; -1 where both lie in front;
// 0 where the surface is flat or bends both ways between them.
int convexity(const GridView& view, HitPair link) {
  const double first = view.grid.plane_of(link.other).signed_distance(view.hit_points[link.hit]);
  const double second = view.grid.plane_of(link.hit).signed_distance(view.hit_points[link.other]);
  if (!(first * second > 0)) return 0;
  return first < 0 ? 1 : -1;
}

// Do the two hits' planes make an edge?
bool is_sharp(const GridView& view, HitPair link) {
  const double cosine =
      view.grid.plane_of(link.hit).normal.dot(view.grid.plane_of(link.other).normal);
  return cosine < kSharpCosine && convexity(view, link) != 0;
}

}  // namespace

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
    if (off <= furthest || beyond(p) >= 0 || beyond(q) >= 0) continue;
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
    if (cut != edge && holds(face, cut)) return off_side(view, face, link, {}, cut);
  }
  Vec3 crease = quadric.minimiser_in(face.lo, face.hi);
  // Beyond both the hits and the face the planes of no sharp edge say nothing: the surface is
  // curved, or bends both ways.
  const Vec3 chord = view.hit_points[link.other] - view.hit_points[link.hit];
  const bool beyond = std::abs(chord.dot(crease - middle)) > 0.5 * chord.squaredNorm();
  if (beyond && on_side(face, crease) && !is_sharp(view, link)) crease = middle;
  crease = behind_planes(view, link, hits, distance, crease);
  return off_side(view, face, link, {}, crease);
}

}  // namespace kdm
