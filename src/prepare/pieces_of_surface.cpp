// SPDX-License-Identifier: MIT
#include "prepare/pieces_of_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/angle.h"
#include "geometry/triangle.h"
#include "mesh/edge_sides.h"

namespace kdm {
namespace {

// A piece ends at an edge if the normals of its two triangles have a lesser cosine.
constexpr double kCutCosine = -0.1;
// A fan that goes on for at least this angle, in radians, is the end of a slit and not of a piece.
constexpr double kLeastSlitAngle = 4.7;
// How much further pieces reach, as a part of the thickness.
constexpr double kOverlap = 1.0 / 4;
// Limits how far a corner goes beyond two sides that meet sharply: as a multiple of the overlap.
constexpr double kMostMitre = 2;

// Returns the vector that leads one unit beyond two sides of a piece's outline, given the unit
// vectors that lead out of each. If one of them is zero, it is the other one.
Vec3 mitred(const Vec3& a, const Vec3& b) {
  const Vec3 sum = a + b;
  const double square = sum.squaredNorm();
  if (a == Vec3::Zero() || b == Vec3::Zero() || !(square > 0)) return sum;
  return sum / std::sqrt(square) * std::min(2 / std::sqrt(square), kMostMitre);
}

}  // namespace

PiecesOfSurface::PiecesOfSurface(std::span<const Triangle> triangles, std::span<const Vec3> points,
                                 std::vector<SideId> opposite, double thickness)
    : triangles_(triangles),
      points_(points),
      thickness_(thickness),
      opposite_(std::move(opposite)),
      rim_(3 * triangles.size()) {
  normals_.reserve(triangles.size());
  for (const Triangle& t : triangles) {
    normals_.push_back(unit_normal(points[t[0]], points[t[1]], points[t[2]]));
  }
  find_ends();
  do {
    find_places();
  } while (cut_off_folded() > 0);
}

bool PiecesOfSurface::has_area() const {
  return std::any_of(normals_.begin(), normals_.end(),
                     [](const Vec3& normal) { return normal != Vec3::Zero(); });
}

double PiecesOfSurface::angle(SideId corner) const {
  return angle_between(point(next_side(corner)) - point(corner),
                       point(previous_side(corner)) - point(corner));
}

// Finds the rim of the surface, and where pieces end within it.
void PiecesOfSurface::find_ends() {
  EdgeSides(triangles_, static_cast<Index>(points_.size()))
      .for_each_edge([&](Index, std::span<const EdgeSide> edge) {
        if (edge.size() == 1) rim_.set(edge[0].side);
      });
  for (SideId side = 0; side < opposite_.size(); ++side) {
    if (opposite_[side] == kNone) continue;
    const Vec3& here = normals_[triangle_of(side)];
    if (here.dot(normals_[triangle_of(opposite_[side])]) < kCutCosine) cut(side);
  }
}

// Ends the piece at a side.
void PiecesOfSurface::cut(SideId side) {
  opposite_[opposite_[side]] = kNone;
  opposite_[side] = kNone;
}

void PiecesOfSurface::find_places() {
  fans_.emplace(opposite_);
  places_.clear();
  for (Index fan = 0; fan < fans_->size(); ++fan) places_.push_back(place_of_fan(fan));
}

Vec3 PiecesOfSurface::place_of_fan(Index fan) const {
  const SideId first = fans_->first(fan);
  const SideId last = previous_side(fans_->last(fan));
  const Vec3& point = this->point(first);
  if (opposite_[first] != kNone) return point;  // the fan goes all the way round
  double angles = 0;
  fans_->for_each_corner(fan, opposite_, [&](SideId corner) {
    if (normals_[triangle_of(corner)] != Vec3::Zero()) angles += angle(corner);
  });
  if (angles >= kLeastSlitAngle) return point;  // the end of a slit stays where it is
  return point + kOverlap * thickness_ * mitred(beyond(first), beyond(last));
}

// Returns the unit vector that leads out of a side's triangle, in its plane, if a piece ends there;
// zero within a piece and at the rim of the surface.
Vec3 PiecesOfSurface::beyond(SideId side) const {
  if (opposite_[side] != kNone || rim_.test(side)) return Vec3::Zero();
  const Vec3 along = point(next_side(side)) - point(side);
  return normalized_or_zero(along.cross(normals_[triangle_of(side)]));
}

// Makes pieces of their own of triangles that are turned over by reaching further, and returns how
// many sides were cut. A piece of one triangle grows.
Index PiecesOfSurface::cut_off_folded() {
  Index cuts = 0;
  for (TriangleId t = 0; t < size(); ++t) {
    const Vec3& n = normals_[t];
    const Vec3& at = place(3 * t);
    if (n == Vec3::Zero() || (place(3 * t + 1) - at).cross(place(3 * t + 2) - at).dot(n) > 0) {
      continue;
    }
    cuts += cut_round(t, opposite_);
  }
  return cuts;
}

}  // namespace kdm
