// SPDX-License-Identifier: MIT
// Finds the mesh vertices that lie on creases, where triangles of different planes meet.
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

/// Finds the vertices of a surface at which the planes of two triangles differ by at least a given
/// angle, and lists the triangles round each vertex. Takes time linear in the triangles.
class CreaseVertices {
 public:
  /// `planes` holds one plane for each triangle; `half_angle_cosine` is the cosine of half the
  /// angle. Each plane at a vertex is compared with the first one there only: a vertex is found if
  /// one of them differs from the first by more than half the angle. So every vertex with two
  /// planes that differ by the whole angle is found, and none at which all planes differ by less
  /// than half of it.
  CreaseVertices(const Surface& surface, std::span<const Plane> planes, double half_angle_cosine);

  /// Returns the vertices that were found, in order of the triangles that led to them.
  const std::vector<CreaseVertex>& all() const { return all_; }
  /// Returns the triangles that have the vertex, in ascending order. Triangles without area have no
  /// plane and are left out.
  std::span<const TriangleId> triangles_round(const CreaseVertex& vertex) const {
    return triangles_round_.of(vertex.point);
  }

 private:
  std::vector<CreaseVertex> all_;
  Groups triangles_round_;  // by point
};

}  // namespace kdm
