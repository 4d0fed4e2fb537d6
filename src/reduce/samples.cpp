// SPDX-License-Identifier: MIT
// Moves samples from triangle to triangle.
#include "reduce/samples.h"

#include <limits>

#include "geometry/distance.h"
#include "geometry/triangle.h"
#include "mesh/sides.h"

namespace kdm {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

}  // namespace

Samples::Places::Target::Target(const std::array<Vec3, 3>& triangle)
    : corners(triangle), normal(unit_normal(triangle[0], triangle[1], triangle[2])) {
  for (int i = 0; i < 3; ++i) inwards[i] = normal.cross(corners[next_corner(i)] - corners[i]);
}

bool Samples::Places::Target::is_beside(const Vec3& p) const {
  const Vec3 off = p - corners[0];
  return inwards[0].dot(off) > 0 && inwards[1].dot(p - corners[1]) > 0 && inwards[2].dot(off) > 0;
}

double Samples::Places::Target::squared_height(const Vec3& p) const {
  const double height = normal.dot(p - corners[0]);
  return height * height;
}

Samples::Samples(const Samples& whole, std::span<const TriangleId> part, const Marks& owned)
    : first_(part.size(), kNone) {
  for (TriangleId t = 0; t < part.size(); ++t) {
    if (!owned.test(t)) continue;
    for (Index s = whole.first_[part[t]]; s != kNone; s = whole.next_[s]) {
      add(whole.point_[s], t, whole.near_[s]);
      copied_of_.push_back(s);
    }
  }
}

void Samples::put_back(const Samples& copied, std::span<const TriangleId> part,
                       const Marks& owned) {
  for (TriangleId t = 0; t < part.size(); ++t) {
    if (!owned.test(t)) continue;
    first_[part[t]] = kNone;
    for (Index s = copied.first_[t]; s != kNone; s = copied.next_[s]) {
      put(copied.copied_of_[s], part[t]);
    }
  }
}

void Samples::add(const Vec3& point, TriangleId t, TriangleId near) {
  point_.push_back(point);
  near_.push_back(near);
  next_.push_back(kNone);
  put(static_cast<Index>(point_.size() - 1), t);
}

// Returns the place of a target that the point is beside and near to, beginning at the target `at`;
// if there is none, of the nearest target. Returns `kNone` if that is too far.
Index Samples::Places::place_of(const Vec3& p, Index at, double limit) const {
  const auto count = static_cast<Index>(targets_.size());
  for (Index i = at; i < at + count; ++i) {
    const Target& target = targets_[i < count ? i : i - count];
    if (target.is_beside(p) && target.squared_height(p) <= limit) return i < count ? i : i - count;
  }
  Index nearest = kNone;
  double least = limit;
  for (Index i = 0; i < count; ++i) {
    const std::array<Vec3, 3>& c = targets_[i].corners;
    const double off = squared_distance(p, c[0], c[1], c[2]);
    if (off > least || (off == least && nearest != kNone)) continue;
    least = off;
    nearest = i;
  }
  return nearest;
}

// Finds places for the samples of a triangle, beginning at the target `at`, then where the sample
// before went: that is near.
bool Samples::find_places(TriangleId from, Index at, double distance, Places& found) const {
  for (Index s = first_[from]; s != kNone; s = next_[s]) {
    const Index place = found.place_of(point_[s], at, distance * distance);
    if (place == kNone) return false;
    at = place;
    found.places_.push_back({s, place});
  }
  return true;
}

bool Samples::fit(const CollapseRing& ring, double distance, Places& places) const {
  places.places_.clear();
  places.targets_.clear();
  for (const RingTriangle& t : ring.triangles) places.targets_.emplace_back(corners_of(ring, t));
  for (const TriangleId t : ring.gone) {
    if (!find_places(t, 0, distance, places)) return false;
  }
  for (Index i = 0; i < ring.triangles.size(); ++i) {
    if (!find_places(ring.triangles[i].number, i, distance, places)) return false;
  }
  find_hints(ring, places);
  return true;
}

bool Samples::fit(const std::array<TriangleId, 2>& triangles,
                  const std::array<std::array<Vec3, 3>, 2>& corners, double distance,
                  Places& places) const {
  places.places_.clear();
  places.targets_.clear();
  for (const std::array<Vec3, 3>& triangle : corners) places.targets_.emplace_back(triangle);
  return find_places(triangles[0], 0, distance, places) &&
         find_places(triangles[1], 1, distance, places);
}

void Samples::find_hints(const CollapseRing& ring, Places& found) const {
  found.hints_.assign(ring.triangles.size(), kNone);
  found.off_.assign(ring.triangles.size(), kFar);
  for (const Places::Place& place : found.places_) {
    const Vec3 middle = 0.5 * (ring.point + ring.triangles[place.target].from_point);
    const double off = (point_[place.sample] - middle).squaredNorm();
    if (off >= found.off_[place.target]) continue;
    found.off_[place.target] = off;
    found.hints_[place.target] = near_[place.sample];
  }
}

void Samples::move(const CollapseRing& ring, const Places& places) {
  for (const TriangleId t : ring.gone) first_[t] = kNone;
  for (const RingTriangle& t : ring.triangles) first_[t.number] = kNone;
  for (const Places::Place& place : places.places_) {
    put(place.sample, ring.triangles[place.target].number);
  }
}

void Samples::move(const std::array<TriangleId, 2>& triangles, const Places& places) {
  for (const TriangleId t : triangles) first_[t] = kNone;
  for (const Places::Place& place : places.places_) put(place.sample, triangles[place.target]);
}

}  // namespace kdm
