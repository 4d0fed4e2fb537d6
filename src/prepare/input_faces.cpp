// SPDX-License-Identifier: MIT
// Checks and welds the input's faces, and repairs them as far as the inside rule needs.
#include "prepare/input_faces.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "kdmanifold/error.h"
#include "mesh/boundary_loops.h"
#include "mesh/boxes.h"
#include "mesh/check_positions.h"
#include "prepare/cancel.h"
#include "prepare/copies.h"
#include "prepare/diagonals.h"
#include "prepare/edit_faces.h"
#include "prepare/extent.h"
#include "prepare/non_manifold_edges.h"
#include "prepare/repair_faces.h"
#include "prepare/two_sided.h"
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

// Drops pairs of faces that lie back to back. They bound nothing, and without them the surface
// meets itself in fewer places.
void cancel_opposite_faces(InputFaces& faces) {
  const Marks cancelled =
      find_opposite_pairs(faces.triangles, static_cast<Index>(faces.points.size()), faces.topology);
  if (!cancelled.any()) return;
  faces.report.cancelled_faces += drop_faces(faces, cancelled);
  if (faces.triangles.empty()) {
    throw Error(ErrorCode::kNotClosed,
                "the surface encloses nothing: the faces of the mesh cancel, each lies back to "
                "back with another; thicken the surface, or take it as a sheet");
  }
  find_topology(faces);
}

// Keeps one of each part that is there several times; if two cancel, only where the number is odd.
void drop_copies(InputFaces& faces, bool two_cancel) {
  const Marks copies = find_copies(faces.triangles, static_cast<Index>(faces.points.size()),
                                   faces.topology, two_cancel);
  if (!copies.any()) return;
  faces.report.duplicate_faces += drop_faces(faces, copies);
  if (faces.triangles.empty()) {
    throw Error(
        ErrorCode::kNotClosed,
        "the surface encloses nothing: each part is there an even number of times, and only "
        "odd winding numbers are inside");
  }
  find_topology(faces);
}

// Says what the input is before anything is done to it.
void describe(InputFaces& faces) {
  const Extent extent = find_extent(faces.triangles, faces.points, faces.topology, faces.bounds);
  InputReport& report = faces.report;
  report.vertices = static_cast<Index>(faces.points.size());
  report.closed = faces.topology.closed();
  report.boundary_edges = faces.topology.boundary_edges;
  report.non_manifold_edges = faces.topology.non_manifold_edges;
  report.components = faces.topology.components;
  report.extent = extent.diagonal;
  report.stray_parts = extent.stray_parts;
}

bool has_two_sides(const InputFaces& faces) {
  return some_part_has_two_sides(faces.triangles, faces.points, faces.topology);
}

// Tells whether some part has two sides, and lets the quads of its backs be cut like their fronts.
bool find_two_sides(InputFaces& faces, double tolerance) {
  std::vector<Triangle> as_given = faces.triangles;
  if (match_diagonals(faces, tolerance) == 0) return has_two_sides(faces);
  find_topology(faces);
  if (has_two_sides(faces)) return true;
  faces.triangles = std::move(as_given);  // solids that touch each other, for instance
  find_topology(faces);
  return has_two_sides(faces);
}

// Makes surfaces that bound a solid, unless `faces.repair` says that this is left to do.
void make_closed(InputFaces& faces, const BuildOptions& options) {
  const bool repair = options.inside == InsideRule::kRepair;
  if (!faces.topology.closed() && !repair) throw_not_closed(faces);
  const double tolerance = tolerance_of(options, faces.report.extent);
  const bool two_sides =
      repair && faces.topology.non_manifold_edges > 0 && find_two_sides(faces, tolerance);
  if (repair && (!faces.topology.closed() || two_sides)) {
    repair_faces(faces, options, tolerance);
    if (faces.repair) return;
  }
  if (repair) {
    tidy_closed_parts(faces);
  } else {
    cancel_opposite_faces(faces);
    if (options.inside == InsideRule::kOdd) drop_copies(faces, true);
  }
}

}  // namespace

void tidy_closed_parts(InputFaces& faces) {
  cancel_opposite_faces(faces);
  drop_copies(faces, false);
  turn_inverted_parts(faces);
}

InputFaces prepare_faces(const Mesh& mesh, const BuildOptions& options) {
  if (mesh.positions.empty()) throw Error(ErrorCode::kInvalidMesh, "the mesh has no vertices");
  check_positions(mesh);
  InputFaces faces;
  collect_faces(mesh, faces);
  faces.report.triangles = static_cast<Index>(faces.triangles.size());
  weld(mesh, faces);
  drop_repeated_corners(faces);
  if (faces.triangles.empty()) {
    throw Error(ErrorCode::kInvalidMesh, "every face of the mesh has two equal corners");
  }
  faces.bounds = bounds_of(faces);
  find_topology(faces);
  describe(faces);
  InputReport& report = faces.report;
  if (options.inside == InsideRule::kSheet) {
    pair_straightest(faces.triangles, faces.points, faces.topology);
    report.boundary_loops = static_cast<Index>(find_rim_loops(faces.topology.opposite).size());
  } else {
    make_closed(faces, options);
  }
  return faces;
}

}  // namespace kdm
