// SPDX-License-Identifier: MIT
// Triangles are neighbours if they have two corners in the same places: the reference may be a
// soup, and neighbours may be turned against each other.
#include "reduce/true_creases.h"

#include <cmath>

#include "geometry/triangle.h"
#include "mesh/edge_sides.h"
#include "prepare/weld.h"

namespace kdm {
namespace {

constexpr double kCreaseCosine = 0.9659258262890683;  // of 15 degrees

// Returns the triangles over points that vertices of equal position share. `points` is set to their
// number.
std::vector<Triangle> join(const ScaledMesh& reference, Index& points) {
  const Weld weld = weld_positions(reference.positions);
  points = static_cast<Index>(weld.first_of.size());
  std::vector<Triangle> triangles;
  triangles.reserve(reference.triangles.size());
  for (const Triangle& t : reference.triangles) {
    triangles.push_back({weld.point_of[t[0]], weld.point_of[t[1]], weld.point_of[t[2]]});
  }
  return triangles;
}

bool turn(std::span<const EdgeSide> sides, const std::vector<Vec3>& normals) {
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const Vec3& normal = normals[triangle_of(sides[i].side)];
    for (std::size_t j = 0; j < i; ++j) {
      if (std::abs(normal.dot(normals[triangle_of(sides[j].side)])) < kCreaseCosine) return true;
    }
  }
  return false;
}

}  // namespace

TrueCreases::TrueCreases(const ScaledMesh& reference, double reach) : width_(2 * reach) {
  std::vector<Vec3> normals;
  normals.reserve(reference.triangles.size());
  for (Index t = 0; t < reference.triangles.size(); ++t) {
    const std::array<Vec3, 3> c = reference.corners(t);
    for (const Vec3& p : c) grow(box_, p);
    normals.push_back(unit_normal(c[0], c[1], c[2]));
  }
  std::vector<std::array<Vec3, 2>> creases;
  Index points = 0;
  const std::vector<Triangle> triangles = join(reference, points);
  EdgeSides(triangles, points).for_each_edge([&](PointId, std::span<const EdgeSide> sides) {
    if (!turn(sides, normals)) return;
    const SideId side = sides.front().side;
    const std::array<Vec3, 3> c = reference.corners(triangle_of(side));
    creases.push_back({c[corner_of(side)], c[next_corner(corner_of(side))]});
  });
  cells_ = CellBits(box_, width_, creases);
}

void TrueCreases::add(std::vector<std::array<Vec3, 2>> segments) {
  if (segments.empty()) return;
  // The mesh may stick out of the reference's box a little.
  for (std::array<Vec3, 2>& segment : segments) {
    for (Vec3& end : segment) end = end.cwiseMax(box_.min).cwiseMin(box_.max);
  }
  added_ = CellBits(box_, width_, segments);
}

}  // namespace kdm
