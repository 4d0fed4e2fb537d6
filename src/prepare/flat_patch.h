// SPDX-License-Identifier: MIT
// Closes holes whose corners lie in one plane by triangles in that plane.
#pragma once

#include <span>
#include <vector>

#include "io/triangulate.h"
#include "prepare/hole_polygon.h"

namespace kdm {

/// Cuts flat polygons, which may have holes, into triangles. Working arrays are kept between calls.
class FlatPatch {
 public:
  /// `points` must be scaled to about 1 and outlive this.
  explicit FlatPatch(const std::vector<Vec3>& points) : points_(points) {}

  /// Appends to `out` triangles over the corners of the first polygon of the group, less the
  /// others, which are holes in it (see `group_nested`). The triangles are oriented like the first
  /// polygon and have all edges of all polygons. Returns false, and appends nothing, if the
  /// polygons cross themselves or each other, or if there are so many holes that it would take too
  /// long.
  bool make(const std::vector<HolePolygon>& polygons, std::span<const Index> group,
            std::vector<Triangle>& out);

 private:
  // A corner in the plane of the first polygon, which runs counter-clockwise there.
  struct Place {
    double u;
    double v;
  };

  Place place_of(PointId point) const;
  double cross(PointId a, PointId b, PointId c) const;
  bool add_hole(const HolePolygon& hole);
  std::size_t find_visible(PointId from) const;
  bool is_within(PointId p, PointId a, const Place& b, PointId c) const;

  const std::vector<Vec3>& points_;
  Triangulator triangulator_;
  std::size_t work_ = 0;  // corners looked at for holes
  int u_axis_ = 0;
  int v_axis_ = 1;
  std::vector<PointId> outline_;  // of the first polygon and of the holes that are joined to it
};

}  // namespace kdm
