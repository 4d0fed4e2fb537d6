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

// The reference's triangles over points that are shared.
struct Joined {
  std::vector<Triangle> triangles;
  std::vector<Vec3> normals;
  Index points;
};

Joined join(const Reference& reference) {
  std::vector<Vec3> corners;
  corners.reserve(3 * std::size_t{reference.size()});
  Joined out;
  for (TriangleId t = 0; t < reference.size(); ++t) {
    const std::array<Vec3, 3>& c = reference.corners(t);
    corners.insert(corners.end(), c.begin(), c.end());
    out.normals.push_back(unit_normal(c[0], c[1], c[2]));
  }
  const Weld weld = weld_positions(corners);
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    out.triangles.push_back({weld.point_of[i], weld.point_of[i + 1], weld.point_of[i + 2]});
  }
  out.points = static_cast<Index>(weld.first_of.size());
  return out;
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

TrueCreases::TrueCreases(const Reference& reference, double reach) : width_(2 * reach) {
  for (TriangleId t = 0; t < reference.size(); ++t) {
    for (const Vec3& p : reference.corners(t)) grow(box_, p);
  }
  cells_ = CellBits(box_, width_);
  const Joined joined = join(reference);
  EdgeSides(joined.triangles, joined.points)
      .for_each_edge([&](PointId, std::span<const EdgeSide> sides) {
        if (!turn(sides, joined.normals)) return;
        const SideId side = sides.front().side;
        const std::array<Vec3, 3>& c = reference.corners(triangle_of(side));
        cells_.mark(c[corner_of(side)], c[next_corner(corner_of(side))]);
      });
  cells_.grow();
}

void TrueCreases::add(const std::vector<std::array<Vec3, 2>>& segments) {
  if (segments.empty()) return;
  added_ = CellBits(box_, width_);
  for (const auto& [from, to] : segments) {
    // The mesh may stick out of the reference's box a little.
    added_.mark(from.cwiseMax(box_.min).cwiseMin(box_.max),
                to.cwiseMax(box_.min).cwiseMin(box_.max));
  }
  added_.grow();
}

}  // namespace kdm
