// SPDX-License-Identifier: MIT
// Where an edge of the mesh may pass through the minimal face of its link.
#include "extract/link_point.h"

#include <algorithm>
#include <cmath>

#include "extract/envelope.h"
#include "geometry/quadric.h"

namespace kdm {
namespace {

// How far an arc between hits of one edge leaves it, as a fraction of their distance.
constexpr double kArcHeight = 0.05;

// How far a vertex keeps off the sides of its face at most, as a fraction of the face's size.
constexpr double kPart = 1.0 / 64;

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

// The point; if both hits lie on a side of the face, a little off it at least.
Vec3 off_side(const std::vector<Vec3>& points, const LinkFace& face, Index hit, Index other,
              Vec3 point) {
  const int side = common_side(face, points[hit], points[other]);
  if (side < 0) return point;
  const int along = 3 - side - face.axis;
  const double width = face.hi[side] - face.lo[side];
  const double length = face.hi[along] - face.lo[along];
  const double distance = std::abs(points[hit][along] - points[other][along]);
  const double height = kArcHeight * distance * std::min(1.0, width / length);
  const bool low = points[hit][side] == face.lo[side];
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

Vec3 chord_point(const std::vector<Vec3>& points, const LinkFace& face, Index hit, Index other) {
  return off_side(points, face, hit, other, 0.5 * (points[hit] + points[other]));
}

Vec3 crease_point(const GridData& grid, const std::vector<Vec3>& points, const LinkFace& face,
                  Index hit, Index other) {
  const Vec3 middle = 0.5 * (points[hit] + points[other]);
  PrimalQuadric quadric(middle);
  quadric.add(grid.plane_of(hit));
  quadric.add(grid.plane_of(other));
  Vec3 crease = quadric.minimiser_in(face.lo, face.hi);
  // Beyond both the hits and the face the planes say nothing: the surface bends both ways.
  const Vec3 chord = points[other] - points[hit];
  if (std::abs(chord.dot(crease - middle)) > 0.5 * chord.squaredNorm() && on_side(face, crease)) {
    crease = middle;
  }
  return off_side(points, face, hit, other, crease);
}

}  // namespace kdm
