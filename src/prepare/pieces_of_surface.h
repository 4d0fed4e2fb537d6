// SPDX-License-Identifier: MIT
// A surface that gets a thickness, in pieces which do not turn too sharply.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "kdmanifold/types.h"
#include "mesh/marks.h"
#include "mesh/numbers.h"
#include "mesh/sides.h"
#include "prepare/fans.h"

namespace kdm {

/// Cuts a surface into pieces: where neighbours agree on no direction, where it turns by more than
/// 95 degrees, and where reaching further would fold a piece. Pieces that end elsewhere than at a
/// rim of the surface reach a quarter of the thickness further, so that what is put on them
/// overlaps. Corners have the numbers of the sides that start from them.
class PiecesOfSurface {
 public:
  /// Coordinates and thickness must be scaled so that they are about 1 at most. `opposite` says
  /// which sides are joined at first. Triangles and points must stay as long as this is used.
  PiecesOfSurface(std::span<const Triangle> triangles, std::span<const Vec3> points,
                  std::vector<SideId> opposite, double thickness);

  TriangleId size() const { return static_cast<TriangleId>(triangles_.size()); }
  /// Returns the side that a side is joined to, for each side; `kNone` where a piece ends.
  std::span<const SideId> opposite() const { return opposite_; }
  /// Returns a triangle's normal, of length 1; zero if it has no area.
  const Vec3& normal(TriangleId triangle) const { return normals_[triangle]; }
  /// Whether any triangle has an area.
  bool has_area() const;
  /// Returns where a corner is.
  const Vec3& point(SideId corner) const {
    return points_[triangles_[triangle_of(corner)][corner_of(corner)]];
  }
  /// Returns the angle of a corner, in radians.
  double angle(SideId corner) const;
  /// Returns the fans that the pieces' ends leave.
  const Fans& fans() const { return *fans_; }
  /// Returns where a corner is once its piece reaches further; it is the same throughout a fan.
  const Vec3& place(SideId corner) const { return places_[fans_->of(corner)]; }

 private:
  void find_ends();
  void cut(SideId side);
  void find_places();
  Vec3 place_of_fan(Index fan) const;
  Vec3 beyond(SideId side) const;
  Index cut_off_folded();

  std::span<const Triangle> triangles_;
  std::span<const Vec3> points_;
  double thickness_;
  std::vector<SideId> opposite_;
  std::vector<Vec3> normals_;
  Marks rim_;  // sides at which the surface itself ends
  std::optional<Fans> fans_;
  std::vector<Vec3> places_;  // per fan
};

}  // namespace kdm
