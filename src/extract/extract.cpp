// SPDX-License-Identifier: MIT
// Grid -> mesh: loops, vertices, strictness, faces.
#include "kdmanifold/extract.h"

#include <fmt/format.h>

#include <array>
#include <initializer_list>
#include <new>

#include "extract/dual/dual_mesh.h"
#include "extract/dual/grid_view.h"
#include "extract/embed/embed.h"
#include "extract/embed/layers.h"
#include "extract/emit.h"
#include "extract/keep_parts.h"
#include "extract/mend/double_edges.h"
#include "extract/mend/slivers.h"
#include "extract/mend/unfold.h"
#include "extract/place/normals.h"
#include "extract/place/place.h"
#include "extract/place/refine.h"
#include "extract/place/split_vertices.h"
#include "kdmanifold/error.h"
#include "mesh/boundary_loops.h"
#include "mesh/progress.h"

namespace kdm {
namespace {

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
  const Vec3 margin = (kMargin * (to_vec3(box.hi) - to_vec3(box.lo))).cwiseMin(tolerance / 2);
  return point.cwiseMax(to_vec3(box.lo) + margin).cwiseMin(to_vec3(box.hi) - margin);
}

// Of the tolerance.
constexpr double kSlightly = 1.0 / 32;

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
    report_progress(progress, 0.4, "vertices");
    boxes_ = cell_boxes(grid_);
    hit_points_ = hit_points(grid_, boxes_, options_.strict == Strict::kEmbedded);
    off_ = place_vertices(view(), error_, options_.position, loops_);
    move_off_slivers(view(), loops_);
  }

  DualMesh faces(const Progress& progress, ExtractReport& report_out) {
    DualMesh mesh;
    if (options_.strict != Strict::kEmbedded || options_.quads) {
      mesh = std::move(loops_);
      make({}, nullptr, mesh);
      if (options_.strict != Strict::kOff) give_area(view(), mesh);
    } else {
      mesh = embedded(progress, report_out);
    }
    report_out.split_vertices = splits_.present(mesh);
    report_out.link_vertices = links_.present(mesh);
    report_out.inserted_vertices = doubles_.present(mesh);
    report_out.flipped_edges = flips_;
    report_out.dropped_pillows = mesh.dropped_pillows;
    return mesh;
  }

 private:
  GridView view() const { return {grid_, boxes_, hit_points_}; }

  // Numbers of vertices that a step has added.
  struct Added {
    std::vector<std::pair<Index, Index>> ranges;

    template <typename Step>
    void note(const DualMesh& mesh, const Step& step) {
      const std::size_t first = mesh.vertices();
      step();
      ranges.emplace_back(first, mesh.vertices());
    }
    Index present(const DualMesh& mesh) const {
      Index count = 0;
      for (const auto& [first, end] : ranges) {
        for (Index v = first; v < end; ++v) count += mesh.first_half_edge[v] != kNone ? 1 : 0;
      }
      return count;
    }
  };

  DualMesh embedded(const Progress& progress, ExtractReport& report_out) {
    // Inside of their leaves nearly all triangles are safe from each other. Vertices at rims stay
    // there, but at tips of corners beyond a leaf's side they do not.
    const double margin = loops_.open ? 0 : kSlightly * grid_.tolerance;
    for (Index v = 0; v < loops_.position.size(); ++v) {
      loops_.position[v] = inside(boxes_[loops_.leaf[v]], margin, loops_.position[v]);
    }
    DualMesh mesh = loops_;
    EmbedSteps steps;
    steps.move = [this](DualMesh& loops, Index v, EmbedLevel level) { move(loops, v, level); };
    steps.make = [this](const EmbedLevels& levels, const Restored* part, DualMesh& made) {
      make(levels, part, made);
    };
    steps.report = [&progress](int round) {
      report_progress(progress, 0.9 - 0.2 / (1 + round), "faces");
    };
    const Embedding embedding = embed(view(), kSlightly * grid_.tolerance, steps, loops_, mesh);
    report_out.refined_hits = embedding.refined_hits;
    report_out.crossings = embedding.crossings;
    return mesh;
  }

  void move(DualMesh& loops, Index v, EmbedLevel level) const {
    if (level < EmbedLevel::kOffSides) return;
    const LatticeBox& box = boxes_[loops.leaf[v]];
    if (level < EmbedLevel::kCentred) {
      loops.position[v] = inside(box, grid_.tolerance, loops.position[v]);
      return;
    }
    // A small loop stays small, or it would reach over those beside it.
    const auto [position, radius] = middle(loops, v);
    loops.position[v] = inside(box, std::min(grid_.tolerance, radius / 4), position);
  }

  void make(const EmbedLevels& levels, const Restored* part, DualMesh& mesh) {
    const Index triangles = mesh.triangles();
    const auto vertices = mesh.vertices();
    std::vector<Index> off;
    const std::vector<Index>& candidates = part == nullptr ? off_ : part->cut;
    std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(off),
                 [&](Index v) { return levels.of_loop(v) == EmbedLevel::kTriangle; });
    splits_.note(mesh, [&] { split_vertices(view(), error_, options_.position, off, mesh); });
    if (!options_.quads) {
      links_.note(mesh, [&] {
        refine(view(), levels, link_error_, mesh, part == nullptr ? nullptr : &part->hits);
      });
    }
    if (part != nullptr) links_.note(mesh, [&] { draw_inwards(levels, part->loops, mesh); });
    if (part == nullptr) {
      if (options_.strict != Strict::kOff) {
        doubles_.note(mesh, [&] { separate_double_edges(view(), mesh); });
      }
      if (options_.unfold && !options_.quads) flips_ += unfold(view(), levels, mesh);
      return;
    }
    const auto with_new = [](std::vector<Index> numbers, Index first, std::size_t end) {
      for (Index i = first; i < end; ++i) numbers.push_back(i);
      return numbers;
    };
    const std::vector<Index> rings = with_new(part->loops, vertices, mesh.vertices());
    doubles_.note(mesh, [&] { separate_double_edges(view(), mesh, &rings); });
    if (!options_.unfold) return;
    std::vector<Index> changed = part->hits;
    changed.insert(changed.end(), mesh.touched_hits.begin(), mesh.touched_hits.end());
    const std::vector<Index> folds = with_new(std::move(changed), triangles, mesh.triangles());
    flips_ += unfold(view(), levels, mesh, &folds);
  }

  void draw_inwards(const EmbedLevels& levels, const std::vector<Index>& loops,
                    DualMesh& mesh) const {
    std::vector<std::pair<Index, Index>> layered;  // leaf and loop
    for (const Index v : loops) {
      if (levels.of_loop(v) == EmbedLevel::kNested) layered.emplace_back(mesh.leaf[v], v);
    }
    std::sort(layered.begin(), layered.end());
    std::vector<Index> together;
    for (std::size_t i = 0; i < layered.size(); ++i) {
      together.push_back(layered[i].second);
      if (i + 1 < layered.size() && layered[i + 1].first == layered[i].first) continue;
      kdm::draw_inwards(boxes_[layered[i].first], together, mesh);
      together.clear();
    }
  }

  // Of the loop's hits, and the distance to the furthest.
  std::pair<Vec3, double> middle(const DualMesh& mesh, Index v) const {
    Vec3 sum = Vec3::Zero();
    int count = 0;
    const auto for_each_point = [&](const auto& visit) {
      for (const HalfEdgeId h : mesh.ring(v)) visit(hit_points_[mesh.hit[h / 3]]);
    };
    for_each_point([&](const Vec3& p) {
      sum += p;
      ++count;
    });
    const Vec3 centre = sum / count;
    double radius = 0;
    for_each_point([&](const Vec3& p) { radius = std::max(radius, (p - centre).norm()); });
    return {centre, radius};
  }

  const GridData& grid_;
  const ExtractOptions& options_;
  SplitError error_;
  double link_error_;
  DualMesh loops_;
  std::vector<LatticeBox> boxes_;
  std::vector<Vec3> hit_points_;
  std::vector<Index> off_;
  Added splits_;
  Added links_;
  Added doubles_;
  Index flips_ = 0;
};

}  // namespace

ExtractedMesh extract(const Grid& handle, const ExtractOptions& options,
                      const Progress& progress) try {
  const GridData& grid = handle.data();
  const double crease = crease_cosine(options);
  Meshing meshing(grid, options);
  report_progress(progress, 0.0, "loops");
  meshing.find_vertices(progress);
  report_progress(progress, 0.7, "faces");
  ExtractedMesh out;
  const DualMesh mesh = meshing.faces(progress, out.report);
  if (mesh.open)
    out.report.boundary_loops = static_cast<Index>(find_rim_loops(mesh.opposite).size());
  report_progress(progress, 0.9, "faces");
  std::vector<Vec3> normals;
  if (options.normals) normals = corner_normals(grid, mesh, crease);
  static_cast<Mesh&>(out) =
      emit(grid, mesh, normals, options.quads, options.strict == Strict::kEmbedded);
  if (!grid.sheet) {
    const KeptParts kept = keep_parts(options.parts, grid.tolerance * grid.lattice.step, out);
    out.report.dropped_parts = kept.dropped;
    out.report.dropped_crumbs = kept.crumbs;
    out.report.invented_area = kept.invented_area;
    if (kept.dropped + kept.crumbs > 0 && out.report.crossings.value_or(0) > 0) {
      out.report.crossings = find_self_intersections(out).pairs;  // some went with the parts
    }
    if (out.triangles.empty() && out.quads.empty() && !grid.hits.empty() && !grid.input.closed) {
      throw Error(ErrorCode::kNotClosed,
                  "the surface encloses nothing that is wider than the tolerance; thicken it, or "
                  "take it as a sheet");
    }
  }
  report_progress(progress, 1.0, "faces");
  return out;
} catch (const std::bad_alloc&) {
  throw Error(ErrorCode::kOutOfMemory, "there is not enough memory to extract the surface");
}

}  // namespace kdm
