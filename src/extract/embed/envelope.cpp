// SPDX-License-Identifier: MIT
// Tests the conditions of envelope.h hit by hit.
#include "extract/embed/envelope.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "extract/dual/clearance.h"
#include "mesh/sort.h"

namespace kdm {

bool double_precision_suffices(const Lattice& lattice) {
  // A coordinate in model units is rounded by 2^-50 of the largest one. Where a plane meets an edge
  // under the sine kLeastSine, the error grows 2^14 times at worst. It must stay below a part of
  // kClear.
  const double largest = lattice.origin.cwiseAbs().maxCoeff() + lattice.step * kLatticeSize;
  return largest < lattice.step * 0x1p50 * 0x1p-14 * (kClear / 16);
}

Envelopes::Envelopes(const GridView& view, const DualMesh& loops, const EditLog& log)
    : view_(view),
      loops_(loops),
      log_(log),
      loop_in_leaf_(view.grid.cells.size(), kNone),
      not_parted_(view.grid.cells.size()),
      has_doubled_link_(view.grid.hits.size()) {
  for (LoopId v = 0; v < loops.vertices(); ++v) loop_in_leaf_[loops.leaf[v]] = v;
  find_doubled_links();
}

void Envelopes::find_doubled_links() {
  std::vector<LoopId> last_linked(view_.grid.cells.size(), kNone);  // per leaf
  for (LoopId v = 0; v < loops_.vertices(); ++v) {
    for (const HalfEdgeId h : loops_.ring(v)) {
      const CellId leaf_beyond = loops_.leaf[loops_.end_vertex(h)];
      if (last_linked[leaf_beyond] == v) mark_links_to(leaf_beyond, v);
      last_linked[leaf_beyond] = v;
    }
  }
}

// Marks the hits on both sides of the loop's links to the leaf.
void Envelopes::mark_links_to(CellId leaf, LoopId v) {
  for (const HalfEdgeId h : loops_.ring(v)) {
    if (loops_.leaf[loops_.end_vertex(h)] != leaf) continue;
    has_doubled_link_.set(h / 3);
    const HalfEdgeId opposite = loops_.opposite[h];
    if (opposite != kNone) has_doubled_link_.set(opposite / 3);
  }
}

void Envelopes::update_leaf(const DualMesh& mesh, const HitTriangles& triangles, CellId leaf) {
  bool parted = false;
  for_each_loop(leaf, [&](LoopId v) {
    parted = parted || parted_along(normal_of(v), mesh, triangles, leaf);
  });
  not_parted_.set(leaf, !parted);
}

// Returns the sum of the normals of the loop's hits.
Vec3 Envelopes::normal_of(LoopId v) const {
  Vec3 sum = Vec3::Zero();
  for_each_hit_round(v, [&](HitId hit) { sum += view_.grid.plane_of(hit).normal; });
  return sum;
}

// Tells whether planes with this normal part the triangles round the loops of the leaf.
bool Envelopes::parted_along(const Vec3& normal, const DualMesh& mesh,
                             const HitTriangles& triangles, CellId leaf) const {
  std::vector<std::pair<double, double>> ranges;  // per loop: of heights along the normal
  for_each_loop(leaf, [&](LoopId v) {
    double lowest = std::numeric_limits<double>::max();
    double highest = std::numeric_limits<double>::lowest();
    for_each_hit_round(v, [&](HitId hit) {
      triangles.for_each(hit, [&](TriangleId t) {
        for (HalfEdgeId h = 3 * t; h < 3 * t + 3; ++h) {
          const double height = normal.dot(mesh.position[mesh.vertex[h]]);
          lowest = std::min(lowest, height);
          highest = std::max(highest, height);
        }
      });
    });
    ranges.emplace_back(lowest, highest);
  });
  sort_up(ranges);
  const double gap = 4 * kClear * normal.norm();
  for (std::size_t i = 1; i < ranges.size(); ++i) {
    if (!(ranges[i].first > ranges[i - 1].second + gap)) return false;
  }
  return true;
}

// Returns the part of the hit's grid edge that all of the hit's leaves, and all leaves of the hits
// across strips from it, have in common.
Envelopes::Stretch Envelopes::stretch_of(HitId hit) const {
  LatticePoint lo = view_.boxes[0].lo;
  LatticePoint hi = view_.boxes[0].hi;
  const auto narrow_to_leaves_of = [&](HitId of_hit) {
    for (HalfEdgeId h = 3 * of_hit; h < 3 * of_hit + 3; ++h) {
      const LatticeBox& box = view_.boxes[loops_.leaf[loops_.vertex[h]]];
      for (int i = 0; i < 3; ++i) {
        lo[i] = std::max(lo[i], box.lo[i]);
        hi[i] = std::min(hi[i], box.hi[i]);
      }
    }
  };
  narrow_to_leaves_of(hit);
  for (Index i = 0; i < 3; ++i) {
    if ((loops_.strip[hit] >> i & 1) != 0) narrow_to_leaves_of(loops_.opposite[3 * hit + i] / 3);
  }
  Stretch found;
  for (int i = 0; i < 3; ++i) {
    if (lo[i] >= hi[i]) continue;
    if (found.axis >= 0) return {};
    found = {i, static_cast<double>(lo[i]), static_cast<double>(hi[i])};
  }
  return found;
}

// Conditions (a) to (c), and whether the hit's triangles were only divided.
bool Envelopes::rim_is_sound(const DualMesh& mesh, HitId hit) const {
  if (has_doubled_link_.test(hit) || log_.edited(hit)) return false;
  for (Index i = 0; i < 3; ++i) {
    const HalfEdgeId h = 3 * hit + i;
    const LoopId v = loops_.vertex[h];
    if (not_parted_.test(loops_.leaf[v]) || loops_.opposite[h] == kNone) return false;
    const LatticeBox& box = view_.boxes[loops_.leaf[v]];
    const Vec3& p = mesh.position[v];
    for (int axis = 0; axis < 3; ++axis) {
      if (!(p[axis] > box.lo[axis] + kClear && p[axis] < box.hi[axis] - kClear)) return false;
    }
    if (((log_.links_inside_face(hit) | loops_.strip[hit]) >> i & 1) == 0) return false;
  }
  return true;
}

// Tests conditions (d) and (e): whether the triangle of the hit is turned as the hit is, and
// whether its plane meets the edge inside of the stretch.
bool Envelopes::passes_through(const Stretch& stretch, const DualMesh& mesh, TriangleId triangle,
                               HitId hit) const {
  const int u = next_axis(stretch.axis);
  const int v = previous_axis(stretch.axis);
  const Vec3& edge = view_.hit_points[hit];
  // Areas and lengths seen along the edge. The plane's height at the edge is the mean of the
  // corners' heights, weighted by the areas that the edge makes with the opposite sides.
  double area = 0;
  double weighted_height = 0;
  double extent = 0;
  for (Index i = 0; i < 3; ++i) {
    const Vec3& p = mesh.position[mesh.vertex[3 * triangle + i]];
    const Vec3& q = mesh.position[mesh.vertex[3 * triangle + (i + 1) % 3]];
    const Vec3& r = mesh.position[mesh.vertex[3 * triangle + (i + 2) % 3]];
    const double weight = (q[u] - edge[u]) * (r[v] - edge[v]) - (q[v] - edge[v]) * (r[u] - edge[u]);
    area += weight;
    weighted_height += weight * (p[stretch.axis] - edge[stretch.axis]);
    extent = std::max({extent, std::abs(p[u] - edge[u]), std::abs(p[v] - edge[v]),
                       std::abs(p[stretch.axis] - edge[stretch.axis])});
  }
  if (!view_.grid.hits[hit].leaving()) {
    area = -area;
    weighted_height = -weighted_height;
  }
  if (!(area > kLeastSine * extent * extent)) return false;
  const double meets_edge_at = edge[stretch.axis] + weighted_height / area;
  return meets_edge_at > stretch.lo + kClear && meets_edge_at < stretch.hi - kClear;
}

bool Envelopes::enclose(const DualMesh& mesh, const HitTriangles& triangles, HitId hit) const {
  if (loops_.dropped(hit)) return true;
  if (!rim_is_sound(mesh, hit)) return false;
  const Stretch stretch = stretch_of(hit);
  if (stretch.axis < 0) return false;
  const auto all_pass = [&](HitId of_hit) {
    bool all = true;
    triangles.for_each(
        of_hit, [&](TriangleId t) { all = all && passes_through(stretch, mesh, t, of_hit); });
    return all;
  };
  if (!all_pass(hit)) return false;
  for (Index i = 0; i < 3; ++i) {
    if ((loops_.strip[hit] >> i & 1) == 0) continue;
    const HitId partner = loops_.opposite[3 * hit + i] / 3;
    if (!rim_is_sound(mesh, partner) || !all_pass(partner)) return false;
  }
  return true;
}

}  // namespace kdm
