// SPDX-License-Identifier: MIT
// What the collapse of an edge would leave, for the tests that decide whether it may happen.
#pragma once

#include <vector>

#include "mesh/numbers.h"
#include "reduce/shape.h"

namespace kdm {

/// A triangle between the vertex that the edge becomes and a side that stays.
struct RingTriangle {
  TriangleId number;
  VertexId from;  ///< the side that stays leads from here
  VertexId to;
  TriangleId beyond;  ///< the triangle on its other side; kNone if there is none
  Vec3 from_point;
  Vec3 to_point;
  Vec3 old_point;  ///< where the third corner is now
  FaceShape before = {};
  FaceShape after = {};
};

/// The triangles round the edge, as they would be.
struct CollapseRing {
  VertexId kept = kNone;     ///< the end of the edge whose number the new vertex has
  VertexId removed = kNone;  ///< the other end
  Vec3 point;                ///< where the new vertex would be
  std::vector<RingTriangle> triangles;
  std::vector<TriangleId> gone;  ///< the triangles beside the edge: two, or one at a rim
};

/// Puts the new vertex to a place.
inline void put_vertex(CollapseRing& ring, const Vec3& point) {
  ring.point = point;
  for (RingTriangle& t : ring.triangles) t.after = face_shape(point, t.from_point, t.to_point);
}

/// Returns the corners of a triangle of the ring, by number, in the order in which `corners_of` has
/// their points.
inline Triangle numbers_of(const CollapseRing& ring, const RingTriangle& t) {
  return {ring.kept, t.from, t.to};
}
inline std::array<Vec3, 3> corners_of(const CollapseRing& ring, const RingTriangle& t) {
  return {ring.point, t.from_point, t.to_point};
}

}  // namespace kdm
