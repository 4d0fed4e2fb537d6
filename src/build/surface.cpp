// SPDX-License-Identifier: MIT
// The input as construction sees it: checks, welding, rounding, orientation.
#include "build/surface.h"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include "geometry/predicates.h"
#include "kdmanifold/error.h"
#include "mesh/boundary_loops.h"
#include "mesh/cancel.h"
#include "mesh/check_positions.h"
#include "mesh/crowded_edges.h"
#include "mesh/orient.h"
#include "mesh/sew.h"
#include "mesh/weld.h"

namespace kdm {
namespace {

// Input triangles with quads cut in two; `source` tells the face each came from.
struct Faces {
  std::vector<Triangle> triangles;
  std::vector<Index> source;
};

Faces collect_faces(const Mesh& mesh) {
  const std::size_t faces = mesh.triangles.size() + mesh.quads.size();
  if (faces == 0) throw Error(ErrorCode::kInvalidMesh, "the mesh has no faces");
  if (!mesh.source_faces.empty() && mesh.source_faces.size() != faces) {
    throw Error(ErrorCode::kInvalidMesh, fmt::format("source_faces has {} entries for {} faces",
                                                     mesh.source_faces.size(), faces));
  }
  if (faces >= (std::size_t{1} << 29)) {
    throw Error(ErrorCode::kInvalidMesh, fmt::format("{} faces; 2^29 is the limit", faces));
  }
  Faces result;
  result.triangles.reserve(mesh.triangles.size() + 2 * mesh.quads.size());
  result.source.reserve(result.triangles.capacity());
  const auto check = [&](std::size_t face, Index vertex) {
    if (vertex >= mesh.positions.size()) {
      throw Error(ErrorCode::kInvalidMesh,
                  fmt::format("indices: face {} names vertex {}, but there are {} vertices", face,
                              vertex, mesh.positions.size()));
    }
  };
  const auto add = [&](std::size_t face, const Triangle& t) {
    result.triangles.push_back(t);
    result.source.push_back(mesh.source_faces.empty() ? static_cast<Index>(face)
                                                      : mesh.source_faces[face]);
  };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const Index vertex : mesh.triangles[i]) check(i, vertex);
    add(i, mesh.triangles[i]);
  }
  for (std::size_t i = 0; i < mesh.quads.size(); ++i) {
    const std::size_t face = mesh.triangles.size() + i;
    const Quad& q = mesh.quads[i];
    for (const Index vertex : q) check(face, vertex);
    add(face, {q[0], q[1], q[2]});
    add(face, {q[0], q[2], q[3]});
  }
  return result;
}

[[noreturn]] void throw_not_closed(const Faces& faces, const std::vector<Vec3>& points,
                                   const Topology& topology) {
  const Index side = topology.first_unbalanced;
  const Triangle& t = faces.triangles[side / 3];
  const Vec3& a = points[t[side % 3]];
  const Vec3& b = points[t[next_corner(static_cast<int>(side % 3))]];
  throw Error(ErrorCode::kNotClosed,
              fmt::format("the surface is not closed and consistently oriented: {} of its edges "
                          "are not used equally often in both directions (boundary edges: {}); "
                          "the first is ({}, {}, {}) - ({}, {}, {}) of face {}",
                          topology.unbalanced_edges, topology.boundary_edges, a[0], a[1], a[2],
                          b[0], b[1], b[2], faces.source[side / 3]));
}

// Faces with a repeated corner have no side that counts. Returns their number.
Index drop_repeated_corners(Faces& faces) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < faces.triangles.size(); ++i) {
    const Triangle& t = faces.triangles[i];
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    faces.triangles[kept] = t;
    faces.source[kept] = faces.source[i];
    ++kept;
  }
  const auto dropped = static_cast<Index>(faces.triangles.size() - kept);
  faces.triangles.resize(kept);
  faces.source.resize(kept);
  return dropped;
}

Box bounds_of(const std::vector<Triangle>& triangles, const std::vector<Vec3>& points) {
  Box bounds{points[triangles[0][0]], points[triangles[0][0]]};
  for (const Triangle& t : triangles) {
    for (const Index corner : t) {
      bounds.min = bounds.min.cwiseMin(points[corner]);
      bounds.max = bounds.max.cwiseMax(points[corner]);
    }
  }
  return bounds;
}

// Takes out pairs of faces that lie back to back: they bound nothing, and without them more of the
// surface is embedded. Returns their number.
Index cancel_opposite_faces(Faces& faces, std::size_t points) {
  const std::vector<char> cancelled =
      find_opposite_pairs(faces.triangles, static_cast<Index>(points));
  std::size_t kept = 0;
  for (std::size_t i = 0; i < faces.triangles.size(); ++i) {
    if (cancelled[i] != 0) continue;
    faces.triangles[kept] = faces.triangles[i];
    faces.source[kept] = faces.source[i];
    ++kept;
  }
  if (kept == 0) {
    throw Error(ErrorCode::kInvalidMesh,
                "the faces of the mesh cancel: each lies back to back with another");
  }
  const auto result = static_cast<Index>(faces.triangles.size() - kept);
  faces.triangles.resize(kept);
  faces.source.resize(kept);
  return result;
}

// Turns neighbours to agree and parts to look outwards, and leaves one of each set of copies.
void turn_outwards(Faces& faces, const std::vector<Vec3>& points, InputReport& report) {
  const Orientation orientation = orient(faces.triangles, points);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < faces.triangles.size(); ++i) {
    if (orientation.copy_of[i] != kNone) continue;
    Triangle t = faces.triangles[i];
    if (orientation.flip[i] != 0) std::swap(t[1], t[2]);
    faces.triangles[kept] = t;
    faces.source[kept] = faces.source[i];
    ++kept;
  }
  report.turned_faces = orientation.flipped_triangles;
  report.duplicate_faces = orientation.copies;
  faces.triangles.resize(kept);
  faces.source.resize(kept);
}

// Throws if a hole is too wide to be closed.
void check_holes(const std::vector<BoundaryLoop>& holes, const std::vector<Triangle>& triangles,
                 const std::vector<Vec3>& points, double largest) {
  Index too_wide = 0;
  double widest = 0;
  Vec3 place;
  for (const BoundaryLoop& hole : holes) {
    const auto corner = [&](Index side) { return points[triangles[side / 3][side % 3]]; };
    Box bounds{corner(hole.vertices[0]), corner(hole.vertices[0])};
    for (const Index side : hole.vertices) {
      bounds.min = bounds.min.cwiseMin(corner(side));
      bounds.max = bounds.max.cwiseMax(corner(side));
    }
    const double width = (bounds.max - bounds.min).norm();
    too_wide += width > largest ? 1 : 0;
    if (width <= widest) continue;
    widest = width;
    place = corner(hole.vertices[0]);
  }
  if (too_wide == 0) return;
  throw Error(ErrorCode::kNotClosed,
              fmt::format("{} of {} holes are wider than largest_hole, which is {}; the widest, {} "
                          "across, passes through ({}, {}, {}): allow wider ones, thicken the "
                          "surface, or take it as a sheet",
                          too_wide, holes.size(), largest, widest, place[0], place[1], place[2]));
}

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
void turn_around(Faces& faces, Topology& topology,
                 std::vector<LatticeTriangle>& lattice_triangles) {
  const auto turned = [](Index side) {
    return side == kNone ? kNone : side - side % 3 + (2 - side % 3);
  };
  std::vector<Index> twin(topology.twin.size());
  for (Index side = 0; side < twin.size(); ++side) twin[turned(side)] = turned(topology.twin[side]);
  topology.twin = std::move(twin);
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
  if (mesh.positions.empty()) throw Error(ErrorCode::kInvalidMesh, "the mesh has no vertices");
  check_positions(mesh);
  Faces faces = collect_faces(mesh);
  const Weld weld = weld_positions(mesh.positions);
  std::vector<Vec3> points;
  points.reserve(weld.first_of.size());
  for (const Index first : weld.first_of) points.push_back(mesh.positions[first]);

  for (Triangle& t : faces.triangles) {
    for (Index& corner : t) corner = weld.point_of[corner];
  }
  Index repeated_corners = drop_repeated_corners(faces);
  if (faces.triangles.empty()) {
    throw Error(ErrorCode::kInvalidMesh, "every face of the mesh has two equal corners");
  }
  const Box bounds = bounds_of(faces.triangles, points);

  Surface surface;
  surface.topology = build_topology(faces.triangles, static_cast<Index>(points.size()));
  surface.report.closed = surface.topology.closed();
  surface.sheet = options.inside == InsideRule::kSheet;
  surface.report.boundary_edges = surface.topology.boundary_edges;
  surface.report.non_manifold_edges = surface.topology.non_manifold_edges;
  surface.report.components = surface.topology.components;
  if (!surface.report.closed && options.inside == InsideRule::kRepair) {
    const double diagonal = (bounds.max - bounds.min).norm();
    surface.report.sewn_edges = sew_rims(tolerance_of(options, diagonal), faces.triangles, points);
    repeated_corners += drop_repeated_corners(faces);
    turn_outwards(faces, points, surface.report);
    surface.topology = build_topology(faces.triangles, static_cast<Index>(points.size()));
    surface.repair = !surface.topology.closed();
  } else if (!surface.report.closed && !surface.sheet) {
    throw_not_closed(faces, points, surface.topology);
  }
  if (surface.has_rims()) pair_straightest(faces.triangles, points, surface.topology);
  const std::vector<BoundaryLoop> holes = find_rim_loops(surface.topology.twin);
  surface.report.boundary_loops = static_cast<Index>(holes.size());
  if (surface.repair && options.largest_hole > 0) {
    check_holes(holes, faces.triangles, points, options.largest_hole);
  }
  if (!surface.has_rims()) {
    surface.report.cancelled_faces = cancel_opposite_faces(faces, points.size());
  }
  if (surface.report.cancelled_faces > 0) {
    surface.topology = build_topology(faces.triangles, static_cast<Index>(points.size()));
  }
  const std::size_t kept = faces.triangles.size();

  surface.lattice = lattice_over(bounds);
  surface.diagonal = (bounds.max - bounds.min).norm();
  std::vector<LatticePoint> rounded(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    // A point that no face uses may lie anywhere; it is not rounded.
    const bool used = (points[i].array() >= bounds.min.array()).all() &&
                      (points[i].array() <= bounds.max.array()).all();
    if (used) rounded[i] = surface.lattice.quantise(points[i]);
  }
  surface.triangles.reserve(kept);
  for (const Triangle& t : faces.triangles) {
    surface.triangles.push_back({rounded[t[0]], rounded[t[1]], rounded[t[2]]});
  }
  surface.report.flipped = !surface.has_rims() && signed_volume(surface.triangles) < 0;
  if (surface.report.flipped) turn_around(faces, surface.topology, surface.triangles);

  surface.planes.reserve(kept);
  surface.degenerate.reserve(kept);
  Index without_area = 0;
  for (std::size_t i = 0; i < kept; ++i) {
    const Triangle& t = faces.triangles[i];
    const auto area = area_vector(surface.triangles[i]);
    const bool degenerate = area[0] == 0 && area[1] == 0 && area[2] == 0;
    surface.degenerate.push_back(degenerate ? 1 : 0);
    without_area += degenerate ? 1 : 0;
    surface.planes.push_back(
        plane_of(surface.lattice.to_lattice(points[t[0]]), surface.lattice.to_lattice(points[t[1]]),
                 surface.lattice.to_lattice(points[t[2]]), surface.triangles[i]));
  }
  surface.corners = std::move(faces.triangles);
  surface.source_faces = std::move(faces.source);
  surface.report.vertices = static_cast<Index>(points.size());
  surface.report.triangles = static_cast<Index>(kept) + repeated_corners +
                             surface.report.cancelled_faces + surface.report.duplicate_faces;
  surface.report.degenerate_faces = repeated_corners + without_area;
  surface.report.lattice_step = surface.lattice.step;
  return surface;
}

}  // namespace kdm
