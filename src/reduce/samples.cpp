// SPDX-License-Identifier: MIT
// Moves samples from triangle to triangle.
#include "reduce/samples.h"

#include <limits>

#include "geometry/distance.h"

namespace kdm {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
// A sample goes to the first triangle that is nearer than this part of the distance allowed; only
// others look for the nearest.
constexpr double kNearEnough = 0.25;

}  // namespace

void Samples::add(const Vec3& point, TriangleId t, TriangleId near) {
  point_.push_back(point);
  near_.push_back(near);
  next_.push_back(kNone);
  put(static_cast<Index>(point_.size() - 1), t);
}

// Finds places for the samples of a triangle, beginning at the target `at`, then where the sample
// before went: that is near.
bool Samples::find_places(TriangleId from, Index at, double distance) {
  const double limit = distance * distance;
  const double enough = kNearEnough * kNearEnough * limit;
  for (Index s = first_[from]; s != kNone; s = next_[s]) {
    double least = kFar;
    Index nearest = 0;
    for (std::size_t i = 0; i < targets_.size(); ++i, ++at) {
      if (at == targets_.size()) at = 0;
      const std::array<Vec3, 3>& t = targets_[at];
      const double off = squared_distance(point_[s], t[0], t[1], t[2]);
      if (off >= least) continue;
      least = off;
      nearest = at;
      if (off <= enough) break;
    }
    if (!(least <= limit)) return false;
    at = nearest;
    places_.push_back({s, nearest});
  }
  return true;
}

bool Samples::fit(const CollapseRing& ring, double distance) {
  places_.clear();
  targets_.clear();
  for (const RingTriangle& t : ring.triangles) targets_.push_back(corners_of(ring, t));
  for (const TriangleId t : ring.gone) {
    if (!find_places(t, 0, distance)) return false;
  }
  for (Index i = 0; i < ring.triangles.size(); ++i) {
    if (!find_places(ring.triangles[i].number, i, distance)) return false;
  }
  find_hints(ring);
  return true;
}

bool Samples::fit(const std::array<TriangleId, 2>& triangles,
                  const std::array<std::array<Vec3, 3>, 2>& corners, double distance) {
  places_.clear();
  targets_.assign(corners.begin(), corners.end());
  return find_places(triangles[0], 0, distance) && find_places(triangles[1], 1, distance);
}

void Samples::find_hints(const CollapseRing& ring) {
  hints_.assign(ring.triangles.size(), kNone);
  off_.assign(ring.triangles.size(), kFar);
  for (const Place& place : places_) {
    const Vec3 middle = 0.5 * (ring.point + ring.triangles[place.target].from_point);
    const double off = (point_[place.sample] - middle).squaredNorm();
    if (off >= off_[place.target]) continue;
    off_[place.target] = off;
    hints_[place.target] = near_[place.sample];
  }
}

void Samples::move(const CollapseRing& ring) {
  for (const TriangleId t : ring.gone) first_[t] = kNone;
  for (const RingTriangle& t : ring.triangles) first_[t.number] = kNone;
  for (const Place& place : places_) put(place.sample, ring.triangles[place.target].number);
}

void Samples::move(const std::array<TriangleId, 2>& triangles) {
  for (const TriangleId t : triangles) first_[t] = kNone;
  for (const Place& place : places_) put(place.sample, triangles[place.target]);
}

}  // namespace kdm
