// SPDX-License-Identifier: MIT
// Prepares the mesh and its reference for the collapser, and hands the result out.
#include "kdmanifold/reduce.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <optional>

#include "kdmanifold/error.h"
#include "kdmanifold/options.h"
#include "mesh/boxes.h"
#include "mesh/check_indices.h"
#include "mesh/check_positions.h"
#include "mesh/marks.h"
#include "mesh/progress.h"
#include "mesh/scale.h"
#include "reduce/carry_over.h"
#include "reduce/face_groups.h"
#include "reduce/level_errors.h"
#include "reduce/local_limits.h"
#include "reduce/pass.h"
#include "reduce/scaled_mesh.h"
#include "text/compose.h"
#include "threads/share_work.h"

namespace kdm {
namespace {

// The part of the work that is done before the first edge is collapsed, and before the levels are
// measured.
constexpr double kBefore = 0.2;
constexpr double kMeasured = 0.95;
// A crease of the mesh is a true one if the reference has one within this part of its diagonal.
constexpr double kCreaseReach = 0.00125;

double diagonal_of(const std::vector<Vec3>& positions) {
  Box box;
  for (const Vec3& p : positions) grow(box, p);
  return (box.max - box.min).norm();
}

// Adds to the reference, whose triangles `kept` holds, those of the mesh that it lacks. Sets `near`
// to one of the triangles that it had which is near to each vertex of the mesh, kNone where there
// is none.
void add_foreign(const ScaledMesh& mesh, double error, ScaledMesh& reference, Reference& kept,
                 std::vector<TriangleId>& near) {
  TriangleId hint = kNone;
  const auto is_near = [&](const Vec3& p) { return kept.is_near(p, kForeign * error, hint); };
  near.assign(mesh.positions.size(), kNone);
  for (PointId p = 0; p < near.size(); ++p) {
    if (is_near(mesh.positions[p])) near[p] = hint;
  }
  const std::size_t given = reference.triangles.size();
  const auto first = static_cast<Index>(reference.positions.size());
  for (TriangleId t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& c = mesh.triangles[t];
    const std::array<Vec3, 3> corners = mesh.corners(t);
    hint = near[c[0]];
    if (hint != kNone && near[c[1]] != kNone && near[c[2]] != kNone &&
        is_near((corners[0] + corners[1] + corners[2]) / 3)) {
      continue;
    }
    reference.triangles.push_back({first + c[0], first + c[1], first + c[2]});
  }
  if (reference.triangles.size() == given) return;
  reference.positions.insert(reference.positions.end(), mesh.positions.begin(),
                             mesh.positions.end());
  kept = Reference(reference.all_corners());
}

// A vertex of the reference begins at the triangle that was found last, if that is nearer than this
// part of the distance allowed; only others look for the nearest.
constexpr double kNearEnough = 0.5;

// Returns the vertices of the mesh and of the reference, each at a triangle of the mesh that is
// near to it. `surface` holds the mesh's triangles, `kept` the reference's, and `near` one of these
// for each vertex of the mesh. Vertices of the reference that the mesh does not come near to are
// left out.
Samples samples_of(const ScaledMesh& mesh, const Reference& surface, const ScaledMesh& reference,
                   const Reference& kept, std::vector<TriangleId>& near, double error) {
  Samples samples(static_cast<Index>(mesh.triangles.size()));
  Marks seen(mesh.positions.size());
  for (TriangleId t = 0; t < mesh.triangles.size(); ++t) {
    for (const PointId p : mesh.triangles[t]) {
      if (seen.test_and_set(p) || !kept.is_near(mesh.positions[p], error, near[p])) continue;
      samples.add(mesh.positions[p], t, near[p]);
    }
  }
  TriangleId hint = kNone;
  seen.assign(reference.positions.size());
  for (TriangleId t = 0; t < reference.triangles.size(); ++t) {
    for (const PointId p : reference.triangles[t]) {
      if (seen.test_and_set(p)) continue;
      if (!surface.is_near(reference.positions[p], kNearEnough * error, hint)) {
        const TriangleId nearest = surface.nearest(reference.positions[p], error, hint);
        if (nearest == kNone) continue;
        hint = nearest;
      }
      samples.add(reference.positions[p], hint, t);
    }
  }
  return samples;
}

// Steps that change triangles at vertices that are not watched are not looked at first: next to
// none lets triangles meet. Vertices whose triangles met others in the end are watched, too, in
// another pass from the start. Where they are more than this part of all, or still some after a few
// passes, all steps are looked at.
constexpr double kMany = 0.02;
constexpr int kMostPasses = 4;

Pass watched_pass(const HalfEdges& half_edges, const std::vector<Vec3>& positions,
                  const std::vector<Index>& groups, const std::optional<KeptDistance>& distance,
                  Marks watched, const std::vector<Index>& targets, const Progress& progress) {
  for (int pass = 1; pass < kMostPasses; ++pass) {
    Workpiece piece(half_edges, positions, distance, watched);
    piece.groups = groups;
    // Most of the time goes into the first pass.
    const double from = pass == 1 ? 0 : 1 - std::pow(0.1, pass - 1);
    Pass out = run_pass(piece, targets, part_of_progress(progress, from, 1 - std::pow(0.1, pass)));
    const Marks meeting = vertices_that_meet(piece, out.levels);
    const std::size_t count = meeting.count();
    if (count == 0) return out;
    if (static_cast<double>(count) > kMany * static_cast<double>(positions.size())) break;
    for (VertexId v = 0; v < watched.size(); ++v) {
      if (meeting.test(v)) watched.set(v);
    }
  }
  Workpiece piece(half_edges, positions, distance);
  piece.groups = groups;
  return run_pass(piece, targets, part_of_progress(progress, 0.999, 1));
}

// Says how far the levels, which `pass_levels` has with coordinates of about 1, are from the
// reference.
void measure_levels(const std::vector<PassLevel>& pass_levels, const LevelErrors& errors,
                    int exponent, std::vector<ReducedLevel>& levels) {
  for (std::size_t i = 0; i < levels.size(); ++i) {
    MeshError& error = levels[i].error;
    error = errors.of(pass_levels[i].mesh);
    for (Deviation* d : {&error.to_input, &error.to_output}) {
      *d = {std::ldexp(d->largest, exponent), std::ldexp(d->rms, exponent)};
    }
  }
}

// Throws if the arrays of a mesh do not fit together.
void check_mesh(const Mesh& mesh) {
  check_indices(mesh);
  check_positions(mesh);
  const std::size_t faces = mesh.triangles.size() + mesh.quads.size();
  if (!mesh.source_faces.empty() && mesh.source_faces.size() != faces) {
    throw Error(ErrorCode::kInvalidMesh, compose("source_faces has {} entries for {} faces",
                                                 mesh.source_faces.size(), faces));
  }
  if (!mesh.source_operands.empty() && mesh.source_operands.size() != faces) {
    throw Error(ErrorCode::kInvalidMesh, compose("source_operands has {} entries for {} faces",
                                                 mesh.source_operands.size(), faces));
  }
  const std::size_t corners = 3 * mesh.triangles.size() + 4 * mesh.quads.size();
  if (!mesh.corner_normals.empty() && mesh.corner_normals.size() != corners) {
    throw Error(ErrorCode::kInvalidMesh, compose("corner_normals has {} entries for {} corners",
                                                 mesh.corner_normals.size(), corners));
  }
}

}  // namespace

ReducedMesh reduce(const Mesh& mesh, const Mesh& reference, const ReduceOptions& options,
                   const Progress& progress) try {
  check_options(options);
  check_mesh(mesh);
  check_mesh(reference);
  report_progress(progress, 0, "reduce");
  const int exponent = scale_to_one(mesh.positions).exponent;
  const ScaledMesh from = scaled_mesh(mesh, -exponent);
  const std::vector<Index> groups = face_groups(mesh, options.keep_groups);
  const HalfEdges half_edges(from.triangles, static_cast<Index>(from.positions.size()));
  const Reference surface(from.all_corners());
  std::optional<Reference> kept;
  std::optional<KeptDistance> distance;
  Marks watched(from.positions.size());
  if (options.error > 0) {
    const ScaledMesh to = scaled_mesh(reference, -exponent);
    const double error = std::ldexp(options.error, -exponent);
    std::vector<TriangleId> near;
    ScaledMesh whole = to;
    kept.emplace(to.all_corners());
    add_foreign(from, error, whole, *kept, near);
    std::optional<Samples> samples;
    std::shared_ptr<const TrueCreases> creases;
    share_parts(2, 1, [&](std::size_t task, std::size_t) {
      if (task == 0) samples = samples_of(from, surface, to, *kept, near, error);
      if (task == 1) {
        creases = std::make_shared<TrueCreases>(whole, kCreaseReach * diagonal_of(to.positions));
      }
    });
    LocalLimits limits = local_limits(from, surface, *kept, near, error);
    watched = std::move(limits.narrow);
    distance.emplace(KeptDistance{&*kept, std::move(*samples), error, std::move(limits.distance),
                                  std::move(near), std::move(creases)});
  }
  std::vector<Index> targets = options.target_triangles;
  if (targets.empty()) targets = {0};
  const Progress steps = part_of_progress(progress, kBefore, kMeasured);
  const Pass pass = watched_pass(half_edges, from.positions, groups, distance, std::move(watched),
                                 targets, steps);
  ReducedMesh out;
  for (const PassLevel& level : pass.levels) {
    ReducedLevel& made = out.levels.emplace_back();
    static_cast<Mesh&>(made) = level.mesh;
    made.positions = scaled(made.positions, exponent);
    carry_over({from, groups, surface}, level.groups, -exponent, made);
  }
  static_cast<Mesh&>(out) = out.levels.back();
  if (options.target_triangles.empty()) out.levels.clear();
  if (!out.levels.empty()) {
    if (!kept) kept.emplace(scaled_mesh(reference, -exponent).all_corners());
    const double reach = options.error > 0 ? kForeign * std::ldexp(options.error, -exponent)
                                           : std::numeric_limits<double>::infinity();
    measure_levels(pass.levels, {*kept, surface, reach}, exponent, out.levels);
  }
  out.report.flips = pass.flips;
  out.report.collapses = pass.collapses;
  out.report.triangles_before = static_cast<Index>(from.triangles.size());
  out.report.triangles = static_cast<Index>(out.triangles.size());
  report_progress(progress, 1, "reduce");
  return out;
} catch (const std::bad_alloc&) {
  throw Error(ErrorCode::kOutOfMemory, "there is not enough memory to reduce the mesh");
}

}  // namespace kdm
