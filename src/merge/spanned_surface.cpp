// SPDX-License-Identifier: MIT
#include "merge/spanned_surface.h"

#include <algorithm>
#include <cmath>

#include "extract/dual/dual_mesh.h"
#include "extract/place/link_point.h"
#include "extract/place/place.h"
#include "mesh/disjoint_sets.h"

namespace kdm {
namespace {

// Rounds a point to the lattice within a box, off its sides where there is room. A triangle in a
// side would reach through it infinitely little, which no split resolves.
LatticePoint rounded_within(const Vec3& point, const Vec3& lo, const Vec3& hi) {
  LatticePoint rounded;
  for (int i = 0; i < 3; ++i) {
    const double margin = hi[i] - lo[i] >= 2 ? 1 : 0;
    rounded[i] = static_cast<std::int32_t>(
        std::clamp(std::floor(point[i] + 0.5), lo[i] + margin, hi[i] - margin));
  }
  return rounded;
}

LatticePoint rounded(const Vec3& point) {
  return rounded_within(point, Vec3::Zero(), Vec3::Constant(kLatticeSize));
}

// Moves a point that lies nearly in some planes into them, by turns; `along` has 0 for the axis
// along which it must not move. Minimisers of quadrics lie a little off, where the planes alone do
// not tell. A point further off than that stays.
Vec3 moved_into(const std::vector<const Plane*>& planes, const Vec3& along, const Vec3& point) {
  constexpr double kNearlyOf =
      1.0 / 1024;                      // fraction of the way that the point may have been drawn
  constexpr double kExact = 1.0 / 16;  // lattice units
  constexpr int kSweeps = 64;
  const auto furthest_off = [&](const Vec3& p) {
    double off = 0;
    for (const Plane* plane : planes) off = std::max(off, plane->distance(p));
    return off;
  };
  const double off = furthest_off(point);
  if (off <= kExact || off > kNearlyOf * kLatticeSize) return point;
  Vec3 moved = point;
  for (int sweep = 0; sweep < kSweeps && furthest_off(moved) > kExact; ++sweep) {
    for (const Plane* plane : planes) {
      const Vec3 normal = plane->normal.cwiseProduct(along);
      const double square = normal.squaredNorm();
      if (square > 1e-6) moved -= plane->signed_distance(moved) / square * normal;
    }
  }
  // Planes that meet nowhere near keep the point that fits them all best.
  return furthest_off(moved) <= kExact && (moved - point).norm() <= 4 * off ? moved : point;
}

class Spanning {
 public:
  Spanning(const GridData& grid, const std::vector<LatticeBox>& boxes)
      : grid_(grid),
        boxes_(boxes),
        hit_points_(hit_points(grid, boxes)),
        mesh_(dual_mesh_of(grid)) {
    find_loops(grid, mesh_);
    const FaceSettings settings{.split_error = standard_split_error(grid),
                                .link_error = grid.tolerance};
    static_cast<void>(place_vertices({grid_, boxes_, hit_points_}, settings, mesh_));
  }

  SpannedSurface run() {
    add_loops_and_hits();
    point_of_link_.assign(mesh_.opposite.size(), kNone);
    for (HitId hit = 0; hit < grid_.hits.size(); ++hit) {
      for (Index h = 3 * hit; h < 3 * hit + 3; ++h) add_fan(h);
    }
    return std::move(spanned_);
  }

 private:
  void add_loops_and_hits() {
    for (VertexId v = 0; v < mesh_.vertices(); ++v) {
      const LatticeBox& box = boxes_[mesh_.leaf[v]];
      planes_.clear();
      for (const HalfEdgeId h : mesh_.ring(v)) planes_.push_back(&grid_.plane_of(h / 3));
      spanned_.points.push_back(rounded_within(moved_into(planes_, Vec3::Ones(), mesh_.position[v]),
                                               to_vec3(box.lo), to_vec3(box.hi)));
    }
    // Hits on both sides of a strip are one point.
    DisjointSets same(grid_.hits.size());
    for (Index h = 0; h < mesh_.opposite.size(); ++h) {
      if (crosses_strip(h)) same.join(h / 3, mesh_.opposite[h] / 3);
    }
    for (HitId hit = 0; hit < grid_.hits.size(); ++hit) {
      const HitId lowest = same.find(hit);
      if (lowest < hit) {
        spanned_.point_of_hit.push_back(spanned_.point_of_hit[lowest]);
        continue;
      }
      spanned_.point_of_hit.push_back(static_cast<PointId>(spanned_.points.size()));
      spanned_.points.push_back(rounded(hit_points_[hit]));
    }
  }

  bool crosses_strip(Index h) const { return (mesh_.strip[h / 3] >> (h % 3) & 1) != 0; }

  void add_fan(Index h) {
    if (crosses_strip(h)) return;
    const PointId link = link_point(h);
    const PointId hit = spanned_.point_of_hit[h / 3];
    add_triangle(h, mesh_.vertex[h], link, hit, mesh_.vertex[h]);
    add_triangle(h, link, mesh_.end_vertex(h), hit, mesh_.end_vertex(h));
  }

  void add_triangle(Index h, PointId a, PointId b, PointId c, VertexId loop) {
    spanned_.corners.push_back({a, b, c});
    spanned_.hit.push_back(h / 3);
    spanned_.leaf.push_back(mesh_.leaf[loop]);
  }

  PointId link_point(Index h) {
    if (point_of_link_[h] != kNone) return point_of_link_[h];
    const Index other = mesh_.opposite[h];
    const auto number = static_cast<PointId>(spanned_.points.size());
    const std::optional<LinkFace> face =
        face_between(boxes_[mesh_.leaf[mesh_.vertex[h]]], boxes_[mesh_.leaf[mesh_.vertex[other]]]);
    if (face) {
      const Vec3 point = crease_point({grid_, boxes_, hit_points_}, *face, {h / 3, other / 3}, {},
                                      grid_.tolerance);
      planes_ = {&grid_.plane_of(h / 3), &grid_.plane_of(other / 3)};
      Vec3 along = Vec3::Ones();
      along[face->axis] = 0;
      spanned_.points.push_back(
          rounded_within(moved_into(planes_, along, point), face->lo, face->hi));
    } else {
      spanned_.points.push_back(spanned_.points[spanned_.point_of_hit[h / 3]]);
    }
    point_of_link_[h] = point_of_link_[other] = number;
    return number;
  }

  const GridData& grid_;
  const std::vector<LatticeBox>& boxes_;
  std::vector<Vec3> hit_points_;
  DualMesh mesh_;
  SpannedSurface spanned_;
  std::vector<const Plane*> planes_;
  std::vector<PointId> point_of_link_;  // per half-edge of the mesh
};

}  // namespace

SpannedSurface span_surface(const GridData& grid, const std::vector<LatticeBox>& boxes) {
  return Spanning(grid, boxes).run();
}

}  // namespace kdm
