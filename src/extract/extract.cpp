// SPDX-License-Identifier: MIT
// Grid -> mesh: loops, vertices, strictness, faces.
#include "kdmanifold/extract.h"

#include <fmt/format.h>

#include <array>
#include <initializer_list>
#include <new>

#include "extract/dual_mesh.h"
#include "extract/embed.h"
#include "extract/emit.h"
#include "extract/keep_parts.h"
#include "extract/normals.h"
#include "extract/place.h"
#include "extract/refine.h"
#include "extract/split_vertices.h"
#include "extract/strict.h"
#include "extract/unfold.h"
#include "kdmanifold/error.h"
#include "mesh/boundary_loops.h"

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

// Cosine of the crease angle.
double crease_cosine(const ExtractOptions& options) {
  if (!(options.crease_angle >= 0 && options.crease_angle <= 180)) {
    throw Error(
        ErrorCode::kInvalidOption,
        fmt::format("crease_angle is {}; it must be from 0 to 180 degrees", options.crease_angle));
  }
  return cosine_of_degrees(options.crease_angle);
}

double link_error(const GridData& grid, const ExtractOptions& options) {
  if (!(options.link_error >= 0)) {
    throw Error(ErrorCode::kInvalidOption,
                fmt::format("link_error is {}; it must be a number that is not negative",
                            options.link_error));
  }
  return options.link_error > 0 ? options.link_error / grid.lattice.step : grid.tolerance;
}

// The point, or one near it that is within the box and off its sides.
Vec3 inside(const LatticeBox& box, double tolerance, const Vec3& point) {
  constexpr double kMargin = 1.0 / 32;
  const Vec3 margin = (kMargin * (real(box.hi) - real(box.lo))).cwiseMin(tolerance / 2);
  return point.cwiseMax(real(box.lo) + margin).cwiseMin(real(box.hi) - margin);
}

// From loops to faces.
class Meshing {
 public:
  Meshing(const GridData& grid, const ExtractOptions& options)
      : grid_(grid),
        options_(options),
        error_(split_error(grid, options)),
        link_error_(link_error(grid, options)) {}

  void find_vertices(const Progress& progress) {
    loops_ = dual_mesh_of(grid_);
    if (options_.strict != Strict::kOff) drop_pillows(loops_);
    find_loops(grid_, loops_);
    report(progress, 0.4, "vertices");
    boxes_ = cell_boxes(grid_);
    points_ = hit_points(grid_, boxes_);
    off_ = place_vertices(grid_, boxes_, points_, error_, options_.position, loops_);
  }

  DualMesh faces(ExtractReport& report) {
    if (options_.strict != Strict::kEmbedded || options_.quads) {
      return refined(std::move(loops_), {}, report);
    }
    Embedding embedding = embed(
        grid_, loops_, [&](const Details& details) { return refined(loops_, details, report); });
    report.refined_hits = embedding.refined_hits;
    report.crossings = embedding.crossings;
    return std::move(embedding.mesh);
  }

 private:
  DualMesh refined(DualMesh mesh, const Details& details, ExtractReport& report) const {
    std::vector<Index> off;
    std::copy_if(off_.begin(), off_.end(), std::back_inserter(off),
                 [&](Index v) { return details.of_loop(v) == Detail::kPlain; });
    for (Index v = 0; v < details.loops.size(); ++v) {
      if (details.loops[v] < Detail::kInside) continue;
      const bool centred = details.loops[v] == Detail::kCentred;
      const Vec3 position = centred ? middle(mesh, v) : mesh.position[v];
      mesh.position[v] = inside(boxes_[mesh.leaf[v]], grid_.tolerance, position);
    }
    report.split_vertices =
        split_vertices(grid_, boxes_, points_, error_, options_.position, off, mesh);
    if (!options_.quads)
      report.link_vertices = refine(grid_, boxes_, points_, details, link_error_, mesh);
    if (options_.strict != Strict::kOff)
      report.inserted_vertices = separate_double_edges(points_, mesh);
    if (options_.unfold && !options_.quads) report.flipped_edges = unfold(grid_, details, mesh);
    report.dropped_pillows = mesh.dropped_pillows;
    return mesh;
  }

  // Of the loop's hits.
  Vec3 middle(const DualMesh& mesh, Index v) const {
    Vec3 sum = Vec3::Zero();
    int count = 0;
    Index half_edge = mesh.first[v];
    do {
      sum += points_[mesh.hit[half_edge / 3]];
      ++count;
      half_edge = mesh.turn(half_edge);
    } while (half_edge != mesh.first[v] && half_edge != kNone);
    return sum / count;
  }

  const GridData& grid_;
  const ExtractOptions& options_;
  SplitError error_;
  double link_error_;
  DualMesh loops_;
  std::vector<LatticeBox> boxes_;
  std::vector<Vec3> points_;
  std::vector<Index> off_;
};

}  // namespace

ExtractedMesh extract(const Grid& handle, const ExtractOptions& options,
                      const Progress& progress) try {
  const GridData& grid = handle.data();
  const double crease = crease_cosine(options);
  Meshing meshing(grid, options);
  report(progress, 0.0, "loops");
  meshing.find_vertices(progress);
  report(progress, 0.7, "faces");
  ExtractedMesh out;
  const DualMesh mesh = meshing.faces(out.report);
  if (mesh.open) out.report.boundary_loops = count_boundary_loops(mesh.opposite);
  report(progress, 0.9, "faces");
  std::vector<Vec3> normals;
  if (options.normals) normals = corner_normals(grid, mesh, crease);
  static_cast<Mesh&>(out) =
      emit(grid, mesh, normals, options.quads, options.strict == Strict::kEmbedded);
  if (!grid.sheet) {
    const KeptParts kept = keep_parts(options.parts, grid.tolerance * grid.lattice.step, out);
    out.report.dropped_parts = kept.dropped;
    out.report.dropped_crumbs = kept.crumbs;
    out.report.invented_area = kept.invented_area;
  }
  report(progress, 1.0, "faces");
  return out;
} catch (const std::bad_alloc&) {
  throw Error(ErrorCode::kOutOfMemory, "there is not enough memory to extract the surface");
}

}  // namespace kdm
