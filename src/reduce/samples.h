// SPDX-License-Identifier: MIT
// Points that the reduced mesh must stay near to, each kept at a triangle that is near to it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/marks.h"
#include "reduce/ring.h"

namespace kdm {

/// The points. When a step replaces triangles, their points move to those that take their place.
class Samples {
 public:
  class Places;

  /// `triangles` is how many triangles the mesh has.
  explicit Samples(Index triangles) : first_(triangles, kNone) {}

  /// Copies the points at some triangles of a mesh: those that `owned` marks among the part's.
  Samples(const Samples& whole, std::span<const TriangleId> part, const Marks& owned);

  /// Takes over where the points of a part that was copied from these went. Parts that own nothing
  /// together may be put back at a time.
  void put_back(const Samples& copied, std::span<const TriangleId> part, const Marks& owned);

  /// Puts a point to a triangle. `near` is a triangle of the reference that is near to the point.
  void add(const Vec3& point, TriangleId t, TriangleId near);

  /// Tells whether each point at the ring's triangles, and at those that go, is within `distance`
  /// of one of the ring's. Sets `places` to where they would go.
  bool fit(const CollapseRing& ring, double distance, Places& places) const;
  /// The same for two triangles, whose corners are to be others.
  bool fit(const std::array<TriangleId, 2>& triangles,
           const std::array<std::array<Vec3, 3>, 2>& corners, double distance,
           Places& places) const;

  /// Moves the points to where `fit` found place for them.
  void move(const CollapseRing& ring, const Places& places);
  void move(const std::array<TriangleId, 2>& triangles, const Places& places);

 private:
  bool find_places(TriangleId from, Index at, double distance, Places& found) const;
  void find_hints(const CollapseRing& ring, Places& found) const;
  void put(Index sample, TriangleId t) {
    next_[sample] = first_[t];
    first_[t] = sample;
  }

  std::vector<Vec3> point_;
  std::vector<TriangleId> near_;  // per sample
  std::vector<Index> next_;       // per sample: the next one at the same triangle
  std::vector<Index> first_;      // per triangle
  std::vector<Index> copied_of_;  // per sample that was copied: the one that it is a copy of
};

/// Where points would go. What it was made for last is forgotten when it is used again.
class Samples::Places {
 public:
  /// After `fit` with a ring: returns, for a triangle of the ring by its place there, a triangle of
  /// the reference that may be near to the middle of its side from the new vertex; kNone if none of
  /// the points would go to it.
  TriangleId hint(std::size_t place) const { return hints_[place]; }

 private:
  friend class Samples;

  // A triangle that points may go to, with what tells quickly whether it is nearest to a point by
  // its inside: the planes through its sides that are perpendicular to it.
  struct Target {
    explicit Target(const std::array<Vec3, 3>& triangle);
    bool is_beside(const Vec3& p) const;
    double squared_height(const Vec3& p) const;

    std::array<Vec3, 3> corners;
    Vec3 normal;                  // zero without area
    std::array<Vec3, 3> inwards;  // for the side from each corner
  };
  struct Place {
    Index sample;
    Index target;  // its place among the targets
  };

  Index place_of(const Vec3& p, Index at, double limit) const;

  std::vector<Target> targets_;  // where points may go
  std::vector<Place> places_;
  std::vector<TriangleId> hints_;  // per triangle of the ring
  std::vector<double> off_;        // per triangle of the ring: how far the hint's point is
};

}  // namespace kdm
