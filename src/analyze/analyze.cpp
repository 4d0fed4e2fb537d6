// SPDX-License-Identifier: MIT
// Joins vertices of equal position, collects what the other files of this room find, and translates
// it to the caller's numbers.
#include "kdmanifold/analyze.h"

#include <algorithm>
#include <new>

#include "analyze/describe.h"
#include "analyze/parts.h"
#include "geometry/exact_sign.h"
#include "kdmanifold/error.h"
#include "mesh/boundary_loops.h"
#include "mesh/check_indices.h"
#include "mesh/check_positions.h"
#include "mesh/faults.h"
#include "mesh/marks.h"
#include "mesh/polygons.h"
#include "mesh/scale.h"
#include "prepare/orient.h"
#include "prepare/weld.h"

namespace kdm {
namespace {

// Returns the mesh with vertices of equal position joined to points. Points are numbered in the
// order of their first vertices: so lists that ascend by points ascend by first vertices as well.
Mesh joined(const Mesh& mesh, const Weld& weld) {
  Mesh result;
  result.positions.reserve(weld.first_of.size());
  for (const Index first : weld.first_of) result.positions.push_back(mesh.positions[first]);
  result.triangles = mesh.triangles;
  for (Triangle& t : result.triangles) {
    for (Index& v : t) v = weld.point_of[v];
  }
  result.quads = mesh.quads;
  for (Quad& q : result.quads) {
    for (Index& v : q) v = weld.point_of[v];
  }
  return result;
}

// Finds faces all of whose corners lie on one line. Faces with a repeated corner are left out.
std::vector<Index> find_zero_area(const Mesh& mesh, const std::vector<Index>& part_of) {
  const std::vector<Vec3> positions = scale_to_one(mesh.positions).positions;
  Marks has_area(part_of.size());
  Polygons(mesh).for_each_triangle([&](Index face, const Triangle& t) {
    for (int axis = 0; axis < 3 && !has_area.test(face); ++axis) {
      has_area.set(face, area_sign(positions[t[0]], positions[t[1]], positions[t[2]], axis) != 0);
    }
  });
  std::vector<Index> found;
  for (Index face = 0; face < part_of.size(); ++face) {
    if (part_of[face] != kNone && !has_area.test(face)) found.push_back(face);
  }
  return found;
}

// Finds faces that are turned the wrong way. The two triangles of a quad share an edge, so they are
// turned together.
std::vector<Index> find_flipped(const Mesh& mesh, const std::vector<Index>& part_of) {
  std::vector<Triangle> triangles;
  std::vector<Index> face_of;
  Polygons(mesh).for_each_triangle([&](Index face, const Triangle& t) {
    if (part_of[face] == kNone) return;
    triangles.push_back(t);
    face_of.push_back(face);
  });
  const Orientation orientation =
      orient(triangles, mesh.positions,
             build_topology(triangles, static_cast<Index>(mesh.positions.size())));
  std::vector<Index> found;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (!orientation.must_turn.test(i)) continue;
    if (found.empty() || found.back() != face_of[i]) found.push_back(face_of[i]);
  }
  return found;
}

}  // namespace

MeshDefects analyze(const Mesh& mesh, const AnalyzeOptions& options) try {
  check_indices(mesh);
  check_positions(mesh);
  const Weld weld = weld_positions(mesh.positions);
  const Mesh points = joined(mesh, weld);
  MeshFaults faults = find_faults(points);
  std::vector<BoundaryLoop> loops = find_boundary_loops(faults.boundary_edges);

  MeshDefects defects;
  defects.report = describe(points, faults, loops);
  PartsReport parts = describe_parts(points, faults, loops);
  defects.parts = std::move(parts.parts);
  defects.nesting_known = parts.nesting_known;
  defects.balanced =
      !defects.parts.empty() && std::all_of(defects.parts.begin(), defects.parts.end(),
                                            [](const MeshPart& part) { return part.closed; });
  // Nothing is turned the wrong way if all parts are closed and none is inside out.
  if (!defects.balanced || std::any_of(defects.parts.begin(), defects.parts.end(),
                                       [](const MeshPart& part) { return part.inside_out; })) {
    defects.flipped_faces = find_flipped(points, faults.part_of);
  }
  defects.zero_area_faces = find_zero_area(points, faults.part_of);
  if (options.self_intersections) {
    SelfIntersections found = find_self_intersections(points);
    defects.self_intersections = found.pairs;
    defects.self_intersecting_faces = std::move(found.faces);
  }
  defects.part_of = std::move(faults.part_of);
  defects.degenerate_faces = std::move(faults.degenerate_faces);
  defects.duplicate_faces = std::move(faults.duplicate_faces);

  const auto vertex = [&](Index point) { return weld.first_of[point]; };
  const auto edge = [&](const Edge& e) { return Edge{vertex(e[0]), vertex(e[1])}; };
  for (const BoundaryEdge& e : faults.boundary_edges) {
    defects.boundary_edges.push_back(edge(e.vertices));
  }
  for (const Edge& e : faults.non_manifold_edges) defects.non_manifold_edges.push_back(edge(e));
  for (const Edge& e : faults.misoriented_edges) defects.misoriented_edges.push_back(edge(e));
  for (const Index v : faults.non_manifold_vertices) {
    defects.non_manifold_vertices.push_back(vertex(v));
  }
  for (BoundaryLoop& loop : loops) {
    for (Index& v : loop.vertices) v = vertex(v);
    defects.boundary_loops.push_back(std::move(loop.vertices));
  }
  return defects;
} catch (const std::bad_alloc&) {
  throw Error(ErrorCode::kOutOfMemory, "not enough memory to analyze the mesh");
}

}  // namespace kdm
