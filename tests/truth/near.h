// SPDX-License-Identifier: MIT
// How far points are from triangles, by looking at all of them.
#pragma once

#include <vector>

#include "kdmanifold/mesh.h"

namespace kdm::truth {

class Near {
 public:
  explicit Near(const Mesh& mesh);

  /// Tells whether a triangle is within the distance of the point.
  bool within(const Vec3& point, double distance);
  /// The distance to the nearest triangle; infinity without triangles.
  double distance(const Vec3& point) const;

 private:
  struct Face {
    Vec3 a, b, c, centre;
    double radius;
  };
  std::vector<Face> faces_;
  std::size_t last_ = 0;  ///< where the point before was near: the next one often is, too
};

}  // namespace kdm::truth
