// SPDX-License-Identifier: MIT
// Triangles that points are held against: how far away the nearest is, and how often they wind
// round a point.
#pragma once

#include <memory>
#include <vector>

#include "geometry/distance.h"
#include "geometry/triangle.h"
#include "mesh/box_tree.h"
#include "prepare/sight.h"

namespace kdm {

/// Triangles with a tree over them, which is made when it is first needed.
class TriangleSet {
 public:
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  std::vector<Index> faces;  ///< per triangle the number of its face

  Index size() const { return static_cast<Index>(triangles.size()); }
  const Vec3& corner(Index triangle, int i) const { return positions[triangles[triangle][i]]; }
  Vec3 doubled_area(Index t) const {
    return doubled_area_vector(corner(t, 0), corner(t, 1), corner(t, 2));
  }
  double area_of(Index t) const { return doubled_area(t).norm() / 2; }

  /// Returns the squared distance of the point from the nearest triangle, or another that is not
  /// above `enough`. `guess` (or kNone) is a triangle that may be near.
  double squared_distance(const Vec3& point, double enough, Index guess);
  /// Returns how often the triangles wind round the point, which must not be on one.
  int winding(const Vec3& point);

 private:
  double squared_distance_of(Index t, const Vec3& point) const {
    return kdm::squared_distance(point, corner(t, 0), corner(t, 1), corner(t, 2));
  }
  const BoxTree& tree();

  std::vector<Box> boxes_;
  std::unique_ptr<BoxTree> tree_;
  std::unique_ptr<Sight> sight_;  // made when somebody asks for winding numbers
  Index last_ = 0;                // the triangle that was nearest last time
};

}  // namespace kdm
