// SPDX-License-Identifier: MIT
// Counts the faults of a mesh, and measures it.
#include "analyze/describe.h"

#include <new>

#include "kdmanifold/error.h"
#include "mesh/boxes.h"
#include "mesh/marks.h"
#include "mesh/measure.h"
#include "mesh/polygons.h"

namespace kdm {
namespace {

template <typename Item>
Index count(const std::vector<Item>& items) {
  return static_cast<Index>(items.size());
}

// Finds the bounds of the vertices that faces use, and counts the others.
void look_at_vertices(const Mesh& mesh, MeshReport& report) {
  const Polygons faces(mesh);
  Marks referenced(mesh.positions.size());
  for (Index face = 0; face < faces.size(); ++face) {
    for (Index k = 0; k < faces.corners(face); ++k) {
      referenced.set(faces[face][k]);
      grow(report.bounds, mesh.positions[faces[face][k]]);
    }
  }
  report.unreferenced_vertices = static_cast<Index>(referenced.size() - referenced.count());
}

}  // namespace

MeshReport describe(const Mesh& mesh, const MeshFaults& faults,
                    std::span<const BoundaryLoop> loops) {
  MeshReport report;
  report.vertices = count(mesh.positions);
  report.triangles = count(mesh.triangles);
  report.quads = count(mesh.quads);
  report.boundary_edges = count(faults.boundary_edges);
  report.boundary_loops = static_cast<Index>(loops.size());
  report.non_manifold_edges = count(faults.non_manifold_edges);
  report.misoriented_edges = count(faults.misoriented_edges);
  report.non_manifold_vertices = count(faults.non_manifold_vertices);
  report.degenerate_faces = count(faults.degenerate_faces);
  report.duplicate_faces = count(faults.duplicate_faces);
  report.components = count(faults.parts);
  const Index faces = Polygons(mesh).size();
  report.euler_characteristic =
      std::int64_t{faults.vertices} - faults.edges + (faces - report.degenerate_faces);
  report.closed = report.boundary_edges == 0 && faces > 0;
  report.manifold = faces > 0 && report.non_manifold_edges == 0 && report.misoriented_edges == 0 &&
                    report.non_manifold_vertices == 0 && report.degenerate_faces == 0 &&
                    report.duplicate_faces == 0;
  report.two_manifold = report.closed && report.manifold;
  look_at_vertices(mesh, report);
  if (faces == 0) return report;
  Measure measure{centre_of(report.bounds)};
  Polygons(mesh).for_each_triangle([&](Index, const Triangle& t) {
    measure.add(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]);
  });
  report.volume = measure.volume;
  report.area = measure.area;
  return report;
}

MeshReport describe(const Mesh& mesh) {
  try {
    const MeshFaults faults = find_faults(mesh);
    return describe(mesh, faults, find_boundary_loops(faults.boundary_edges));
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::kOutOfMemory, "not enough memory to describe the mesh");
  }
}

}  // namespace kdm
