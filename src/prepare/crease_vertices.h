// SPDX-License-Identifier: MIT
// The mesh vertices that lie on creases: triangles whose planes differ meet there.
#pragma once

#include <span>
#include <vector>

#include "mesh/groups.h"
#include "mesh/numbers.h"
#include "prepare/surface.h"

namespace kdm {

/// A mesh vertex at which triangles of different planes meet.
struct CreaseVertex {
  PointId point;    ///< the number by which the surface's triangles name it
  LatticePoint at;  ///< its position, rounded to the lattice
};

/// Finds the vertices of a surface at which the planes of two triangles differ by an angle, and
/// keeps the triangles round each. Takes time linear in the triangles.
class CreaseVertices {
 public:
  /// `planes` holds one plane a triangle, `half_angle_cosine` the cosine of half the angle. Each
  /// plane at a vertex is compared with the first one only. So every vertex with two planes that
  /// differ by the angle is found; of the others, those may be found whose planes differ by more
  /// than half the angle.
  CreaseVertices(const Surface& surface, std::span<const Plane> planes, double half_angle_cosine);

  /// The vertices found, in order of the first triangle that told.
  const std::vector<CreaseVertex>& all() const { return all_; }
  /// The triangles that have the vertex, ascending. Triangles without area have no plane and are
  /// left out.
  std::span<const TriangleId> triangles_round(const CreaseVertex& vertex) const {
    return triangles_round_.of(vertex.point);
  }

 private:
  std::vector<CreaseVertex> all_;
  Groups triangles_round_;  // by point
};

}  // namespace kdm
