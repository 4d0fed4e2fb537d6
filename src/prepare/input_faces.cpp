// SPDX-License-Identifier: MIT
// Checks and welds the input's faces, and repairs them as far as the inside rule needs.
#include "prepare/input_faces.h"

#include <algorithm>

#include "kdmanifold/error.h"
#include "mesh/boundary_loops.h"
#include "mesh/boxes.h"
#include "mesh/check_positions.h"
#include "prepare/cancel.h"
#include "prepare/non_manifold_edges.h"
#include "prepare/orient.h"
#include "prepare/sew.h"
#include "prepare/weld.h"
#include "text/compose.h"

namespace kdm {
namespace {

[[noreturn]] void throw_bad_index(std::size_t face, Index vertex, std::size_t vertices) {
  throw Error(ErrorCode::kInvalidMesh,
              compose("indices: face {} names vertex {}, but there are {} vertices", face, vertex,
                      vertices));
}

// Collects the mesh's triangles and the halves of its quads. Corners are vertices of the mesh.
void collect_faces(const Mesh& mesh, InputFaces& result) {
  const std::size_t faces = mesh.triangles.size() + mesh.quads.size();
  if (faces == 0) throw Error(ErrorCode::kInvalidMesh, "the mesh has no faces");
  if (!mesh.source_faces.empty() && mesh.source_faces.size() != faces) {
    throw Error(ErrorCode::kInvalidMesh, compose("source_faces has {} entries for {} faces",
                                                 mesh.source_faces.size(), faces));
  }
  if (faces >= (std::size_t{1} << 29)) {
    throw Error(ErrorCode::kInvalidMesh, compose("{} faces; 2^29 is the limit", faces));
  }
  result.triangles.reserve(mesh.triangles.size() + 2 * mesh.quads.size());
  result.source_faces.reserve(result.triangles.capacity());
  const auto check = [&](std::size_t face, Index vertex) {
    if (vertex >= mesh.positions.size()) throw_bad_index(face, vertex, mesh.positions.size());
  };
  const auto add = [&](std::size_t face, const Triangle& t) {
    result.triangles.push_back(t);
    result.source_faces.push_back(mesh.source_faces.empty() ? static_cast<Index>(face)
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
}

void weld(const Mesh& mesh, InputFaces& faces) {
  const Weld weld = weld_positions(mesh.positions);
  faces.points.reserve(weld.first_of.size());
  for (const Index first : weld.first_of) faces.points.push_back(mesh.positions[first]);
  for (Triangle& t : faces.triangles) {
    for (Index& corner : t) corner = weld.point_of[corner];
  }
}

Box bounds_of(const std::vector<Triangle>& triangles, const std::vector<Vec3>& points) {
  Box bounds;
  for (const Triangle& t : triangles) {
    for (const Index corner : t) grow(bounds, points[corner]);
  }
  return bounds;
}

[[noreturn]] void throw_not_closed(const InputFaces& faces) {
  const Topology& topology = faces.topology;
  const Index side = topology.first_unbalanced;
  const Triangle& t = faces.triangles[side / 3];
  const Vec3& a = faces.points[t[side % 3]];
  const Vec3& b = faces.points[t[next_corner(static_cast<int>(side % 3))]];
  throw Error(ErrorCode::kNotClosed,
              compose("the surface is not closed and consistently oriented: {} of its edges "
                      "are not used equally often in both directions (boundary edges: {}); "
                      "the first is ({}, {}, {}) - ({}, {}, {}) of face {}",
                      topology.unbalanced_edges, topology.boundary_edges, a[0], a[1], a[2], b[0],
                      b[1], b[2], faces.source_faces[side / 3]));
}

// Keeps the triangles for whose number `keep` is true, in their order. Returns how many were
// dropped.
template <typename Keep>
Index keep_faces(InputFaces& faces, const Keep& keep) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < faces.triangles.size(); ++i) {
    if (!keep(i)) continue;
    faces.triangles[kept] = faces.triangles[i];
    faces.source_faces[kept] = faces.source_faces[i];
    ++kept;
  }
  const auto dropped = static_cast<Index>(faces.triangles.size() - kept);
  faces.triangles.resize(kept);
  faces.source_faces.resize(kept);
  return dropped;
}

// Drops faces with two equal corners: they have no area.
void drop_repeated_corners(InputFaces& faces) {
  faces.report.degenerate_faces += keep_faces(faces, [&](std::size_t i) {
    const Triangle& t = faces.triangles[i];
    return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
  });
  if (faces.triangles.empty()) {
    throw Error(ErrorCode::kInvalidMesh, "every face of the mesh has two equal corners");
  }
}

// Drops pairs of faces that lie back to back. They bound nothing, and without them the surface
// meets itself in fewer places.
void cancel_opposite_faces(InputFaces& faces) {
  const Marks cancelled =
      find_opposite_pairs(faces.triangles, static_cast<Index>(faces.points.size()), faces.topology);
  if (!cancelled.any()) return;
  faces.report.cancelled_faces =
      keep_faces(faces, [&](std::size_t i) { return !cancelled.test(i); });
  if (faces.triangles.empty()) {
    throw Error(ErrorCode::kInvalidMesh,
                "the faces of the mesh cancel: each lies back to back with another");
  }
}

// Turns faces so that neighbours agree and parts look outwards. Of several faces over the same
// corners one is kept.
void turn_outwards(InputFaces& faces) {
  const Orientation orientation = orient(faces.triangles, faces.points);
  for (std::size_t i = 0; i < faces.triangles.size(); ++i) {
    if (orientation.must_turn.test(i)) std::swap(faces.triangles[i][1], faces.triangles[i][2]);
  }
  keep_faces(faces, [&](std::size_t i) { return orientation.copy_of[i] == kNone; });
  faces.report.turned_faces = orientation.flipped_triangles;
  faces.report.duplicate_faces = orientation.copies;
}

// Throws if a hole's bounding box has a diagonal of more than `largest`, in model units.
void check_holes(const std::vector<BoundaryLoop>& holes, const InputFaces& faces, double largest) {
  Index too_wide = 0;
  double widest = 0;
  Vec3 place = Vec3::Zero();
  for (const BoundaryLoop& hole : holes) {
    const auto corner = [&](Index side) {
      return faces.points[faces.triangles[side / 3][side % 3]];
    };
    Box bounds;
    for (const Index side : hole.vertices) grow(bounds, corner(side));
    const double width = (bounds.max - bounds.min).norm();
    too_wide += width > largest ? 1 : 0;
    if (width <= widest) continue;
    widest = width;
    place = corner(hole.vertices[0]);
  }
  if (too_wide == 0) return;
  throw Error(ErrorCode::kNotClosed,
              compose("{} of {} holes are wider than largest_hole, which is {}; the widest, {} "
                      "across, passes through ({}, {}, {}): allow wider ones, thicken the "
                      "surface, or take it as a sheet",
                      too_wide, holes.size(), largest, widest, place[0], place[1], place[2]));
}

void find_topology(InputFaces& faces) {
  faces.topology = build_topology(faces.triangles, static_cast<Index>(faces.points.size()));
}

// Sews rims together and turns the faces. Returns whether the surface is still not closed.
bool sew_and_turn(InputFaces& faces, const BuildOptions& options) {
  const double diagonal = (faces.bounds.max - faces.bounds.min).norm();
  faces.report.sewn_edges =
      sew_rims(tolerance_of(options, diagonal), faces.triangles, faces.points);
  drop_repeated_corners(faces);
  turn_outwards(faces);
  find_topology(faces);
  return !faces.topology.closed();
}

}  // namespace

InputFaces prepare_faces(const Mesh& mesh, const BuildOptions& options) {
  if (mesh.positions.empty()) throw Error(ErrorCode::kInvalidMesh, "the mesh has no vertices");
  check_positions(mesh);
  InputFaces faces;
  collect_faces(mesh, faces);
  weld(mesh, faces);
  drop_repeated_corners(faces);
  faces.bounds = bounds_of(faces.triangles, faces.points);
  find_topology(faces);
  InputReport& report = faces.report;
  report.vertices = static_cast<Index>(faces.points.size());
  report.closed = faces.topology.closed();
  report.boundary_edges = faces.topology.boundary_edges;
  report.non_manifold_edges = faces.topology.non_manifold_edges;
  report.components = faces.topology.components;
  const bool sheet = options.inside == InsideRule::kSheet;
  if (!report.closed && options.inside == InsideRule::kRepair) {
    faces.repair = sew_and_turn(faces, options);
  } else if (!report.closed && !sheet) {
    throw_not_closed(faces);
  }
  if (sheet || faces.repair) {
    pair_straightest(faces.triangles, faces.points, faces.topology);
    const std::vector<BoundaryLoop> holes = find_rim_loops(faces.topology.opposite);
    report.boundary_loops = static_cast<Index>(holes.size());
    if (faces.repair && options.largest_hole > 0) check_holes(holes, faces, options.largest_hole);
  } else {
    cancel_opposite_faces(faces);
    if (report.cancelled_faces > 0) find_topology(faces);
  }
  report.triangles = static_cast<Index>(faces.triangles.size()) + report.degenerate_faces +
                     report.cancelled_faces + report.duplicate_faces;
  return faces;
}

}  // namespace kdm
