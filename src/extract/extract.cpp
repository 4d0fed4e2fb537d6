// SPDX-License-Identifier: MIT
// Turns a grid into a mesh: finds loops, places vertices, embeds the mesh if asked to, and emits
// faces.
#include "kdmanifold/extract.h"

#include <algorithm>
#include <limits>
#include <new>
#include <utility>

#include "extract/drop_handles.h"
#include "extract/dual/edit_log.h"
#include "extract/dual/grid_view.h"
#include "extract/embed/embed.h"
#include "extract/emit.h"
#include "extract/exact_faces.h"
#include "extract/keep_parts.h"
#include "extract/mend/give_area.h"
#include "extract/mend/mend_edges.h"
#include "extract/mend/slivers.h"
#include "extract/place/add_vertices.h"
#include "extract/place/normals.h"
#include "extract/place/place.h"
#include "extract/warnings.h"
#include "kdmanifold/error.h"
#include "kdmanifold/options.h"
#include "mesh/boundary_loops.h"
#include "mesh/measure.h"
#include "mesh/progress.h"
#include "text/compose.h"

namespace kdm {
namespace {

SplitError split_error(const GridData& grid, const ExtractOptions& options) {
  if (options.split_error > 0) return SplitError{options.split_error / grid.lattice.step, 0};
  if (options.quads) return {};
  return standard_split_error(grid);
}

double link_error(const GridData& grid, const ExtractOptions& options) {
  return options.link_error > 0 ? options.link_error / grid.lattice.step : grid.tolerance;
}

FaceSettings face_settings(const GridData& grid, const ExtractOptions& options) {
  return {.split_error = split_error(grid, options),
          .link_error = link_error(grid, options),
          .position = options.position,
          .quads = options.quads,
          .two_manifold = options.strict != Strict::kOff,
          .unfold = options.unfold};
}

void count_edits(const DualMesh& mesh, const EditLog& log, ExtractReport& report) {
  report.split_vertices = log.added_vertices(AddedBy::kVertexSplits, mesh);
  report.link_vertices = log.added_vertices(AddedBy::kLinks, mesh);
  report.inserted_vertices = log.added_vertices(AddedBy::kDoubleEdges, mesh);
  report.flipped_edges = log.flips();
}

// Makes the dual mesh of the grid with all its vertices, and counts in the report what the steps
// did.
DualMesh surface_of(const GridData& grid, const ExtractOptions& options, const Progress& progress,
                    ExtractReport& report) {
  const FaceSettings settings = face_settings(grid, options);
  report_progress(progress, 0.0, "loops");
  DualMesh mesh = dual_mesh_of(grid);
  if (settings.two_manifold) report.dropped_pillows = drop_pillows(mesh);
  find_loops(grid, mesh);
  report_progress(progress, 0.4, "vertices");
  const std::vector<LatticeBox> boxes = cell_boxes(grid);
  const std::vector<Vec3> points = hit_points(grid, boxes, options.strict == Strict::kEmbedded);
  const GridView view{grid, boxes, points};
  const std::vector<LoopId> missed = place_vertices(view, settings, mesh);
  if (grid.simplified == 0) move_off_slivers(view, mesh);
  report_progress(progress, 0.7, "faces");
  if (options.strict == Strict::kEmbedded) {
    Embedding embedding =
        embed(view, settings, missed, progress, grid.sheet ? mesh : std::move(mesh));
    report.crossings = embedding.crossings;
    // Sheets that cross each other are left so: what was done to part them has only moved them.
    if (!grid.sheet || embedding.crossings == 0) {
      report.refined_hits = embedding.refined_hits;
      count_edits(embedding.mesh, embedding.log, report);
      return std::move(embedding.mesh);
    }
  }
  EditLog log;
  add_vertices(view, settings, {}, missed, mesh, log);
  mend_edges(view, settings, {}, mesh, log);
  if (settings.two_manifold) give_area(view, mesh);
  count_edits(mesh, log, report);
  return mesh;
}

// Sheets enclose nothing, so that there is no part to be chosen by what lies in it.
void check_for_sheet(const ExtractOptions& options) {
  if (options.parts != Parts::kAll) {
    throw Error(ErrorCode::kInvalidOption, "`parts`: only all for a sheet, which encloses nothing");
  }
  for (const auto& [name, size] : {std::pair("drop_parts", options.drop_parts),
                                   std::pair("drop_cavities", options.drop_cavities),
                                   std::pair("drop_handles", options.drop_handles)}) {
    if (size == 0) continue;
    throw Error(ErrorCode::kInvalidOption,
                compose("`{}`: not for a sheet, which encloses nothing", name));
  }
}

// Leaves parts out of a solid's mesh.
void leave_parts_out(const GridData& grid, const ExtractOptions& options, ExtractedMesh& out) {
  const auto faces = out.triangles.size() + out.quads.size();
  const KeptParts kept = keep_parts(options, grid.tolerance * grid.lattice.step, out);
  out.report.dropped_parts = kept.dropped;
  out.report.small_parts = kept.small_parts.count;
  out.report.small_parts_volume = kept.small_parts.volume;
  out.report.small_cavities = kept.small_cavities.count;
  out.report.small_cavities_volume = kept.small_cavities.volume;
  out.report.dropped_crumbs = kept.crumbs;
  out.report.invented_area = kept.invented_area;
  const bool some_went = out.triangles.size() + out.quads.size() < faces;
  if (some_went && out.report.crossings.value_or(0) > 0) {
    out.report.crossings = find_self_intersections(out).pairs;  // some went with the parts
  }
}

// Removes small handles of a solid's mesh. Vertices are moved within the tolerance, if there is
// one.
void leave_handles_out(const GridData& grid, const ExtractOptions& options,
                       const Progress& progress, ExtractedMesh& out) {
  const HandleSettings settings{.smaller_than = options.drop_handles,
                                .shift = grid.tolerance > 0
                                             ? grid.tolerance * grid.lattice.step
                                             : std::numeric_limits<double>::infinity(),
                                .single = options.strict == Strict::kEmbedded};
  const DroppedHandles handles = drop_handles(settings, progress, out);
  out.report.small_handles = handles.dropped;
  out.report.kept_handles = handles.kept;
}

// Throws if nothing is left, with what to do about it.
void check_not_empty(const GridData& grid, const ExtractedMesh& out) {
  if (!out.triangles.empty() || !out.quads.empty()) return;
  if (out.report.small_parts > 0) {
    throw Error(ErrorCode::kEmptyResult, "all parts of the result are smaller than `drop_parts`");
  }
  if (!grid.operands.empty()) {
    throw Error(ErrorCode::kEmptyResult,
                "the Boolean operation leaves nothing, or nothing that is wider than the tolerance "
                "or the cells of the grid");
  }
  if (!grid.sheet && !grid.hits.empty() && !grid.input.closed) {
    throw Error(ErrorCode::kNotClosed,
                "the surface encloses nothing that is wider than the tolerance; thicken it, or "
                "take it as a sheet");
  }
  throw Error(ErrorCode::kEmptyResult,
              "nothing of the surface is left: it is nowhere wider than the tolerance or the cells "
              "of the grid; take a smaller tolerance or a greater depth, or thicken the surface");
}

// Tells whether 32 bits hold coordinates of the size of the model's.
bool fits_in_single(const Lattice& lattice) {
  const Vec3 far = lattice.to_model(Vec3::Constant(kLatticeSize));
  const double largest = std::max(lattice.origin.cwiseAbs().maxCoeff(), far.cwiseAbs().maxCoeff());
  return largest <= std::numeric_limits<float>::max() &&
         lattice.step >= std::numeric_limits<float>::min();
}

// Sides of dropped triangles are no rim, whatever they were linked to.
Index count_rim_loops(const DualMesh& mesh) {
  std::vector<SideId> opposite(mesh.opposite.begin(), mesh.opposite.end());
  for (SideId side = 0; side < opposite.size(); ++side) {
    if (mesh.dropped(triangle_of(side))) opposite[side] = side;
  }
  return static_cast<Index>(find_rim_loops(opposite).size());
}

}  // namespace

ExtractedMesh extract(const Grid& handle, const ExtractOptions& wanted,
                      const Progress& progress) try {
  check_options(wanted);
  const GridData& grid = handle.data();
  if (grid.sheet) check_for_sheet(wanted);
  ExtractOptions options = wanted;
  if (options.strict == Strict::kEmbedded && (options.quads || !fits_in_single(grid.lattice))) {
    options.strict = Strict::kManifold;
  }
  const double crease = cosine_of_degrees(options.crease_angle);
  ExtractedMesh out;
  const DualMesh mesh = surface_of(grid, options, progress, out.report);
  if (mesh.open) {
    out.report.boundary_loops = count_rim_loops(mesh);
  }
  report_progress(progress, 0.9, "faces");
  std::vector<Vec3> normals;
  if (options.normals) normals = corner_normals(grid, mesh, crease);
  static_cast<Mesh&>(out) =
      emit(grid, mesh, normals, options.quads, options.strict == Strict::kEmbedded);
  if (grid.sheet && out.report.crossings.value_or(0) > 0) {
    out.report.crossings = std::max<std::uint64_t>(find_self_intersections(out).pairs, 1);
  }
  if (!grid.exact.triangles.empty()) {
    if (out.report.crossings && !out.triangles.empty()) {
      *out.report.crossings += count_crossings(out, grid.exact);
    }
    append_exact(grid.exact, options, out);
  }
  if (!grid.sheet) leave_parts_out(grid, options, out);
  check_not_empty(grid, out);
  if (options.drop_handles > 0) leave_handles_out(grid, options, progress, out);
  out.warnings = collect_warnings(grid.input, grid.stats, out.report, area_of(out));
  report_progress(progress, 1.0, "faces");
  return out;
} catch (const std::bad_alloc&) {
  throw Error(ErrorCode::kOutOfMemory, "there is not enough memory to extract the surface");
}

}  // namespace kdm
