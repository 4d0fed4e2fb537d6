// SPDX-License-Identifier: MIT
// Grid -> mesh: loops, vertices, strictness, faces.
#include "kdmanifold/extract.h"

#include <fmt/format.h>

#include <new>

#include "extract/dual_mesh.h"
#include "extract/place.h"
#include "extract/split_vertices.h"
#include "extract/strict.h"
#include "extract/unfold.h"
#include "kdmanifold/error.h"
#include "mesh/topology.h"

namespace kdm {
namespace {

void report(const Progress& progress, double fraction, std::string_view phase) {
  if (progress && !progress(fraction, phase)) {
    throw Error(ErrorCode::kAborted, "stopped by the progress callback");
  }
}

// Where the surface is merely curved, a leaf's vertex lies a little off its planes, and splits
// would fold it: by default only what looks like a second feature is split.
constexpr double kFeature = 0.3;

SplitError split_error(const GridData& grid, const ExtractOptions& options) {
  if (!(options.split_error >= 0)) {
    throw Error(ErrorCode::kInvalidOption,
                fmt::format("split_error is {}; it must be a number that is not negative",
                            options.split_error));
  }
  if (options.split_error > 0) return SplitError{options.split_error / grid.lattice.step, 0};
  if (options.quads) return {};
  return SplitError{grid.tolerance, kFeature};
}

// The half-edge of triangle t across which it makes a quad, or kNone.
Index quad_diagonal(const DualMesh& mesh, Index t) {
  for (Index i = 0; i < 3; ++i) {
    const Index half_edge = 3 * t + i;
    if ((mesh.strip[t] >> i & 1) == 0) continue;
    const Index other = mesh.opposite[half_edge];
    const bool both = (mesh.strip[other / 3] >> (other % 3) & 1) != 0;
    const Index c = mesh.vertex[previous_in_triangle(half_edge)];
    if (both && c != mesh.vertex[previous_in_triangle(other)]) return half_edge;
  }
  return kNone;
}

void emit(const GridData& grid, const DualMesh& mesh, bool quads, ExtractedMesh& out) {
  out.positions.reserve(mesh.position.size());
  for (const Vec3& p : mesh.position) out.positions.push_back(grid.lattice.to_model(p));
  const auto source = [&](Index t) { return grid.source_faces[grid.hits[mesh.hit[t]].plane()]; };
  std::vector<Index> quad_sources;
  out.triangles.reserve(mesh.triangles());
  out.source_faces.reserve(mesh.triangles());
  for (Index t = 0; t < mesh.triangles(); ++t) {
    if (mesh.dropped(t)) continue;
    const Index diagonal = quads ? quad_diagonal(mesh, t) : kNone;
    if (diagonal == kNone) {
      out.triangles.push_back({mesh.vertex[3 * t], mesh.vertex[3 * t + 1], mesh.vertex[3 * t + 2]});
      out.source_faces.push_back(source(t));
      continue;
    }
    const Index other = mesh.opposite[diagonal];
    if (other / 3 < t) continue;  // made with its partner
    out.quads.push_back({mesh.vertex[diagonal], mesh.vertex[previous_in_triangle(other)],
                         mesh.vertex[other], mesh.vertex[previous_in_triangle(diagonal)]});
    quad_sources.push_back(source(t));
  }
  out.source_faces.insert(out.source_faces.end(), quad_sources.begin(), quad_sources.end());
}

}  // namespace

ExtractedMesh extract(const Grid& handle, const ExtractOptions& options,
                      const Progress& progress) try {
  const GridData& grid = handle.data();
  const SplitError error = split_error(grid, options);
  report(progress, 0.0, "loops");
  DualMesh mesh = dual_mesh_of(grid);
  if (options.strict) drop_pillows(mesh);
  find_loops(grid, mesh);
  report(progress, 0.4, "vertices");
  const std::vector<LatticeBox> boxes = cell_boxes(grid);
  const std::vector<Vec3> points = hit_points(grid, boxes);
  const std::vector<Index> off = place_vertices(grid, boxes, points, error, mesh);
  ExtractedMesh out;
  report(progress, 0.7, "vertices");
  out.report.split_vertices = split_vertices(grid, boxes, points, error, off, mesh);
  report(progress, 0.8, "faces");
  if (options.strict) out.report.inserted_vertices = separate_double_edges(points, mesh);
  if (options.unfold && !options.quads) out.report.flipped_edges = unfold(grid, mesh);
  out.report.dropped_pillows = mesh.dropped_pillows;
  if (mesh.open) out.report.boundary_loops = count_boundary_loops(mesh.opposite);
  emit(grid, mesh, options.quads, out);
  report(progress, 1.0, "faces");
  return out;
} catch (const std::bad_alloc&) {
  throw Error(ErrorCode::kOutOfMemory, "there is not enough memory to extract the surface");
}

}  // namespace kdm
