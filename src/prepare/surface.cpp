// SPDX-License-Identifier: MIT
// Rounds the input's triangles to the lattice, computes their planes, and turns a solid that is
// inside out.
#include "prepare/surface.h"

#include <Eigen/Geometry>

#include "geometry/predicates.h"
#include "kdmanifold/error.h"
#include "text/compose.h"

namespace kdm {
namespace {

// Returns six times the enclosed volume, summed over tetrahedra that share the root cell's middle.
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

// Exchanges corners 1 and 2 of every triangle. Thereby its side 0, between corners 0 and 1, becomes
// side 2, and side 2 becomes side 0.
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
  for (PatchPlane& plane : faces.patch_planes) plane.normal = -plane.normal;
  for (LatticeTriangle& t : lattice_triangles) std::swap(t[1], t[2]);
}

// Returns the plane of a triangle whose corners before rounding are a, b, c, with a normal of
// length one; zero if the triangle has no area before rounding nor after it.
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

// The points of the faces in lattice units. A point that no face uses may lie anywhere; it is left
// at zero.
struct LatticePoints {
  std::vector<LatticePoint> rounded;
  std::vector<Vec3> exact;
};

LatticePoints to_lattice(const InputFaces& faces, const Lattice& lattice) {
  const Box& bounds = faces.bounds;
  LatticePoints result;
  result.rounded.resize(faces.points.size());
  result.exact.resize(faces.points.size());
  for (PointId i = 0; i < faces.points.size(); ++i) {
    const Vec3& point = faces.points[i];
    const bool within =
        (point.array() >= bounds.min.array()).all() && (point.array() <= bounds.max.array()).all();
    if (!within) continue;
    result.rounded[i] = lattice.quantise(point);
    result.exact[i] = lattice.to_lattice(point);
  }
  return result;
}

// Adds the planes of the surface's triangles, and marks and counts triangles without area.
void find_planes(const InputFaces& faces, const std::vector<Vec3>& exact, Surface& surface) {
  const std::vector<Triangle>& corners = faces.triangles;
  surface.planes.reserve(corners.size());
  surface.degenerate.reserve(corners.size());
  for (TriangleId i = 0; i < corners.size(); ++i) {
    const Triangle& t = corners[i];
    const auto area = area_vector(surface.triangles[i]);
    const bool degenerate = area[0] == 0 && area[1] == 0 && area[2] == 0;
    surface.degenerate.push_back(degenerate);
    surface.report.degenerate_faces += degenerate ? 1 : 0;
    surface.planes.push_back(plane_of(exact[t[0]], exact[t[1]], exact[t[2]], surface.triangles[i]));
  }
  Plane* plane = surface.planes.data() + corners.size() - faces.patch_planes.size();
  for (const PatchPlane& patch : faces.patch_planes) {
    if (patch.normal != Vec3::Zero()) {
      *plane = {patch.normal, patch.normal.dot(surface.lattice.to_lattice(patch.point))};
    }
    ++plane;
  }
}

}  // namespace

Lattice lattice_for(const Box& bounds, const BuildOptions& options) {
  Box box = bounds;
  if (options.box) {
    box.min = Vec3(options.box->data());
    box.max = Vec3(options.box->data() + 3);
  }
  if ((bounds.min.array() < box.min.array()).any() ||
      (bounds.max.array() > box.max.array()).any()) {
    throw Error(ErrorCode::kInvalidOption,
                compose("`box`: the model reaches out of it; its own box is {},{},{},{},{},{}",
                        bounds.min[0], bounds.min[1], bounds.min[2], bounds.max[0], bounds.max[1],
                        bounds.max[2]));
  }
  return options.cells > 0 ? lattice_of_cells(box, options.cells) : lattice_over(box);
}

Surface prepare_surface(InputFaces faces, const BuildOptions& options) {
  const Lattice lattice = lattice_for(faces.bounds, options);
  return surface_of(std::move(faces), lattice, options.inside == InsideRule::kSheet);
}

Surface surface_of(InputFaces faces, const Lattice& lattice, bool sheet) {
  Surface surface;
  surface.sheet = sheet;
  surface.repair = faces.repair;
  surface.patched = !faces.patch_planes.empty();
  surface.report = faces.report;
  surface.lattice = lattice;
  surface.report.lattice_step = surface.lattice.step;
  surface.extent = faces.report.extent;
  const LatticePoints points = to_lattice(faces, surface.lattice);
  surface.triangles.reserve(faces.triangles.size());
  for (const Triangle& t : faces.triangles) {
    surface.triangles.push_back({points.rounded[t[0]], points.rounded[t[1]], points.rounded[t[2]]});
  }
  if (!surface.has_rims() && signed_volume(surface.triangles) < 0) {
    surface.report.flipped = true;
    turn_around(faces, surface.triangles);
  }
  find_planes(faces, points.exact, surface);
  surface.topology = std::move(faces.topology);
  surface.part_of = find_parts(surface.topology);
  surface.corners = std::move(faces.triangles);
  surface.points = std::move(faces.points);
  surface.source_faces = std::move(faces.source_faces);
  return surface;
}

}  // namespace kdm
