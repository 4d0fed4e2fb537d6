// SPDX-License-Identifier: MIT
// Reduces meshes as they are where that can be done, and others once they have been made anew.
#include <numeric>

#include "kdmanifold/make_manifold.h"
#include "kdmanifold/options.h"
#include "mesh/check_indices.h"
#include "mesh/check_positions.h"
#include "prepare/weld.h"

namespace kdm {
namespace {

// Rounds coordinates to 32 bits, as results have them, joins vertices of equal position and numbers
// the faces, unless they are. Faces that lose a corner stay: the mesh is then not 2-manifold.
Mesh joined(const Mesh& mesh) {
  Mesh out = mesh;
  for (Vec3& p : out.positions) p = p.cast<float>().cast<double>();
  const Weld weld = weld_positions(out.positions);
  std::vector<Vec3> positions;
  for (const Index vertex : weld.first_of) positions.push_back(out.positions[vertex]);
  out.positions = std::move(positions);
  for (Triangle& t : out.triangles) {
    for (Index& v : t) v = weld.point_of[v];
  }
  for (Quad& q : out.quads) {
    for (Index& v : q) v = weld.point_of[v];
  }
  if (out.source_faces.empty()) {
    out.source_faces.resize(out.triangles.size() + out.quads.size());
    std::iota(out.source_faces.begin(), out.source_faces.end(), Index{0});
  }
  return out;
}

bool is_sound(const Mesh& mesh) {
  const MeshReport report = describe(mesh);
  return report.two_manifold && report.volume > 0 && find_self_intersections(mesh).pairs == 0;
}

SimplifiedMesh reduced(const Mesh& mesh, const Mesh& reference, const ReduceOptions& options,
                       const StepProgress& progress) {
  ReducedMesh few =
      reduce(mesh, reference, options, progress ? progress(MakeStep::kReduce) : Progress());
  return {std::move(static_cast<Mesh&>(few)), std::move(few.levels), few.report, {}, false};
}

}  // namespace

SimplifiedMesh simplify_mesh(const Mesh& mesh, const ReduceOptions& options,
                             const StepProgress& progress) {
  check_options(options);
  check_indices(mesh);
  check_positions(mesh);
  const Mesh own = joined(mesh);
  if (is_sound(own)) return reduced(own, own, options, progress);
  MakeOptions rebuild;
  rebuild.build.tolerance = options.error;
  rebuild.extract.strict = Strict::kEmbedded;
  rebuild.reduction.target_triangles = options.target_triangles;
  rebuild.reduction.keep_groups = options.keep_groups;
  SimplifiedMesh out;
  if (options.error > 0) {
    MadeManifold made = make_manifold_in_steps(mesh, rebuild, progress);
    out = {std::move(static_cast<Mesh&>(made)), std::move(made.levels), *made.reduced,
           std::move(made.warnings), true};
    return out;
  }
  // Nothing but the numbers counts: the surface is made first, and then reduced without limit.
  rebuild.reduction = {.reduce = false};
  const MadeManifold made = make_manifold_in_steps(mesh, rebuild, progress);
  out = reduced(made, made, options, progress);
  out.warnings = made.warnings;
  out.rebuilt = true;
  return out;
}

}  // namespace kdm
