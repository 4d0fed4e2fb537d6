// SPDX-License-Identifier: MIT
#include "reduce/pass.h"

#include <algorithm>
#include <utility>

#include "geometry/exact_sign.h"
#include "mesh/progress.h"
#include "reduce/collapse_blocks.h"
#include "reduce/collapser.h"
#include "reduce/flips.h"

namespace kdm {
namespace {

PassLevel level_of(const Workpiece& piece) {
  PassLevel out;
  const HalfEdges& mesh = piece.mesh;
  std::vector<Index> numbers(mesh.vertices(), kNone);
  for (VertexId v = 0; v < mesh.vertices(); ++v) {
    if (mesh.leaving(v) == kNone) continue;
    numbers[v] = static_cast<Index>(out.vertices.size());
    out.vertices.push_back(v);
    out.mesh.positions.push_back(piece.positions[v]);
  }
  for (TriangleId t = 0; t < mesh.triangles(); ++t) {
    if (mesh.is_removed(t)) continue;
    const Triangle c = mesh.corners(t);
    out.mesh.triangles.push_back({numbers[c[0]], numbers[c[1]], numbers[c[2]]});
    if (!piece.groups.empty()) out.groups.push_back(piece.groups[t]);
  }
  return out;
}

}  // namespace

Pass run_pass(Workpiece& piece, const std::vector<Index>& targets, const Progress& progress) {
  Pass out;
  const Index at_first = piece.mesh.living_triangles();
  // What is left to do is known where a number of triangles is asked for.
  const double to_go = std::max(1u, at_first - std::min(at_first, targets.back()));
  const auto report_gone = [&](Index gone) { report_progress(progress, gone / to_go, "reduce"); };
  const auto report = [&] { report_gone(at_first - piece.mesh.living_triangles()); };
  if (piece.distance) find_crossing_creases(piece);
  CollapseState state = first_state(piece);
  BlockSteps in_blocks;
  // Where a number of triangles is asked for, the cheapest edges of all go first.
  if (targets == std::vector<Index>{0} && is_worth_blocks(piece)) {
    in_blocks = collapse_in_blocks(piece, state, report_gone);
    out.flips += in_blocks.flips;
  } else if (piece.distance) {
    out.flips += flip_false_creases(piece);
  }
  Collapser collapser(piece, std::move(state));
  for (const Index target : targets) {
    collapser.collapse_to(target, report);
    if (piece.distance && out.levels.size() + 1 == targets.size()) {
      out.flips += flip_false_creases(piece);
    }
    out.levels.push_back(level_of(piece));
  }
  out.collapses = in_blocks.collapses + collapser.collapses();
  return out;
}

Marks vertices_that_meet(const Workpiece& piece, const std::vector<PassLevel>& levels) {
  Marks found(piece.positions.size());
  for (const PassLevel& level : levels) {
    const auto mark = [&](Index t) {
      for (const Index corner : level.mesh.triangles[t]) found.set(level.vertices[corner]);
    };
    for (const Index face : find_self_intersections(level.mesh).faces) mark(face);
    for (Index t = 0; t < level.mesh.triangles.size(); ++t) {
      const Triangle& c = level.mesh.triangles[t];
      const std::vector<Vec3>& points = level.mesh.positions;
      if (!has_area(points[c[0]], points[c[1]], points[c[2]])) mark(t);
    }
  }
  if (!found.any()) return found;
  // A vertex goes the way of those that it was joined to, one after the other.
  Marks all(piece.positions.size());
  for (VertexId v = 0; v < all.size(); ++v) {
    bool is_marked = false;
    for (VertexId at = v; at != kNone && !is_marked; at = piece.joined_to[at]) {
      is_marked = found.test(at);
    }
    all.set(v, is_marked);
  }
  return all;
}

}  // namespace kdm
