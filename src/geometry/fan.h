// SPDX-License-Identifier: MIT
// Whether the triangles round a vertex surely meet in nothing but it and the sides they share.
#pragma once

#include <Eigen/Geometry>
#include <span>

#include "kdmanifold/types.h"

namespace kdm {

/// The side of a triangle that is opposite to a vertex; both ends relative to the vertex.
struct OuterSide {
  OuterSide(const Vec3& start, const Vec3& end)
      : from(start), to(end), doubled_area(from.cross(to)) {}

  Vec3 from;
  Vec3 to;
  Vec3 doubled_area;  ///< the area vector of the triangle, twice
};

/// Tells whether, seen along `normal`, the triangles between a vertex and its outer sides, which
/// are those of a closed ring in any order, lie beside each other, all turned the right way. Then
/// no two of them meet but where they share corners. If not, they may or may not meet.
///
/// Triangles that are turned the right way take less than half a turn each, so the ring of their
/// outer sides runs round the vertex as often as it rises from below a line through the vertex to
/// above it: that must be once.
inline bool is_simple_fan(std::span<const OuterSide> sides, const Vec3& normal) {
  // The least area of a triangle seen along the normal, as a part of the squares of its sides: far
  // more than what rounding does to areas.
  constexpr double kLeastArea = 1e-6;
  int axis = 0;
  normal.cwiseAbs().minCoeff(&axis);
  const Vec3 upwards = normal.cross(Vec3::Unit(axis));
  const double size = normal.cwiseAbs().sum();
  int rises = 0;
  for (const OuterSide& side : sides) {
    const double area = side.doubled_area.dot(normal);
    if (!(area > kLeastArea * size * (side.from.squaredNorm() + side.to.squaredNorm()))) {
      return false;
    }
    rises += upwards.dot(side.from) < 0 && upwards.dot(side.to) >= 0 ? 1 : 0;
  }
  return rises == 1;
}

/// Tells the same, seen along the sum of the triangles' normals.
inline bool is_simple_fan(std::span<const OuterSide> sides) {
  Vec3 normal = Vec3::Zero();
  for (const OuterSide& side : sides) normal += side.doubled_area;
  return is_simple_fan(sides, normal);
}

}  // namespace kdm
