// SPDX-License-Identifier: MIT
// Places the vertices of loops off the sides of their leaves.
#include "extract/embed/loop_position.h"

#include <algorithm>

namespace kdm {
namespace {

struct HitCluster {
  Vec3 centre;
  double radius;  // the distance from the centre to the furthest hit, lattice units
};

HitCluster hits_round(const GridView& view, const DualMesh& loops, LoopId v) {
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (const HalfEdgeId h : loops.ring(v)) {
    sum += view.hit_points[loops.hit[h / 3]];
    ++count;
  }
  HitCluster cluster{sum / count, 0};
  for (const HalfEdgeId h : loops.ring(v)) {
    const Vec3& p = view.hit_points[loops.hit[h / 3]];
    cluster.radius = std::max(cluster.radius, (p - cluster.centre).norm());
  }
  return cluster;
}

}  // namespace

Vec3 off_sides(const LatticeBox& box, double tolerance, const Vec3& point) {
  constexpr double kMargin = 1.0 / 32;
  const Vec3 lo = to_vec3(box.lo);
  const Vec3 hi = to_vec3(box.hi);
  const Vec3 margin = (kMargin * (hi - lo)).cwiseMin(tolerance / 2);
  return point.cwiseMax(lo + margin).cwiseMin(hi - margin);
}

Vec3 loop_position(const GridView& view, const DualMesh& loops, LoopId v, EmbedLevel level) {
  if (level < EmbedLevel::kOffSides) return loops.position[v];
  const LatticeBox& box = view.boxes[loops.leaf[v]];
  const double tolerance = view.grid.tolerance;
  if (level < EmbedLevel::kCentred) return off_sides(box, tolerance, loops.position[v]);
  // A small loop moves little, or its triangles would reach over the loops beside it.
  const auto [centre, radius] = hits_round(view, loops, v);
  return off_sides(box, std::min(tolerance, radius / 4), centre);
}

}  // namespace kdm
