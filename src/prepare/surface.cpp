// SPDX-License-Identifier: MIT
// The input as construction sees it: rounding to the lattice, planes, the solid turned outwards.
#include "prepare/surface.h"

#include <Eigen/Geometry>

#include "geometry/predicates.h"

namespace kdm {
namespace {

// Six times the enclosed volume, about the middle of the root cell.
double signed_volume(const std::vector<LatticeTriangle>& triangles) {
  constexpr double kMiddle = kLatticeSize / 2.0;
  double sum = 0;
  for (const LatticeTriangle& t : triangles) {
    Vec3 corner[3];
    for (int i = 0; i < 3; ++i) {
      corner[i] = Vec3(t[i][0] - kMiddle, t[i][1] - kMiddle, t[i][2] - kMiddle);
    }
    sum += corner[0].dot(corner[1].cross(corner[2]));
  }
  return sum;
}

// Exchanges corners 1 and 2 of every triangle: side 0 (0,1) becomes side 2 and the other way round.
void turn_around(InputFaces& faces, std::vector<LatticeTriangle>& lattice_triangles) {
  const auto turned = [](SideId side) {
    return side == kNone ? kNone : side - side % 3 + (2 - side % 3);
  };
  std::vector<SideId>& opposite = faces.topology.opposite;
  std::vector<SideId> result(opposite.size());
  for (SideId side = 0; side < opposite.size(); ++side) {
    result[turned(side)] = turned(opposite[side]);
  }
  opposite = std::move(result);
  for (Triangle& t : faces.triangles) std::swap(t[1], t[2]);
  for (LatticeTriangle& t : lattice_triangles) std::swap(t[1], t[2]);
}

Plane plane_of(const Vec3& a, const Vec3& b, const Vec3& c, const LatticeTriangle& rounded) {
  Vec3 normal = (b - a).cross(c - a);
  double length = normal.norm();
  if (!(length > 0)) {  // no area before rounding, some after it
    const auto area = area_vector(rounded);
    normal = Vec3(static_cast<double>(area[0]), static_cast<double>(area[1]),
                  static_cast<double>(area[2]));
    length = normal.norm();
    if (!(length > 0)) return {};
  }
  normal /= length;
  return {normal, normal.dot((a + b + c) / 3.0)};
}

}  // namespace

Surface prepare_surface(const Mesh& mesh, const BuildOptions& options) {
  InputFaces faces = prepare_faces(mesh, options);
  const Box& bounds = faces.bounds;
  const std::vector<Vec3>& points = faces.points;
  Surface surface;
  surface.sheet = options.inside == InsideRule::kSheet;
  surface.repair = faces.repair;
  surface.report = faces.report;
  surface.lattice = lattice_over(bounds);
  surface.diagonal = (bounds.max - bounds.min).norm();
  std::vector<LatticePoint> rounded(points.size());
  std::vector<Vec3> exact(points.size());  // lattice units, before rounding
  for (std::size_t i = 0; i < points.size(); ++i) {
    // A point that no face uses may lie anywhere; it is not rounded.
    const bool used = (points[i].array() >= bounds.min.array()).all() &&
                      (points[i].array() <= bounds.max.array()).all();
    if (!used) continue;
    rounded[i] = surface.lattice.quantise(points[i]);
    exact[i] = surface.lattice.to_lattice(points[i]);
  }
  const std::size_t size = faces.triangles.size();
  surface.triangles.reserve(size);
  for (const Triangle& t : faces.triangles) {
    surface.triangles.push_back({rounded[t[0]], rounded[t[1]], rounded[t[2]]});
  }
  surface.report.flipped = !surface.has_rims() && signed_volume(surface.triangles) < 0;
  if (surface.report.flipped) turn_around(faces, surface.triangles);

  surface.planes.reserve(size);
  surface.degenerate.reserve(size);
  for (std::size_t i = 0; i < size; ++i) {
    const Triangle& t = faces.triangles[i];
    const auto area = area_vector(surface.triangles[i]);
    const bool degenerate = area[0] == 0 && area[1] == 0 && area[2] == 0;
    surface.degenerate.push_back(degenerate);
    surface.report.degenerate_faces += degenerate ? 1 : 0;
    surface.planes.push_back(plane_of(exact[t[0]], exact[t[1]], exact[t[2]], surface.triangles[i]));
  }
  surface.report.lattice_step = surface.lattice.step;
  surface.topology = std::move(faces.topology);
  surface.corners = std::move(faces.triangles);
  surface.source_faces = std::move(faces.source);
  return surface;
}

}  // namespace kdm
