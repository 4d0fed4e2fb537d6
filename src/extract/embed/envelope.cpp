// SPDX-License-Identifier: MIT
// The test of single hits.
#include "extract/embed/envelope.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kdm {

bool rounds_little(const Lattice& lattice) {
  // A coordinate in model units is rounded by 2^-50 of the largest; kLeastSine makes it 2^14 times
  // as much at worst.
  const double largest = lattice.origin.cwiseAbs().maxCoeff() + lattice.step * kLatticeSize;
  return largest < lattice.step * 0x1p50 * 0x1p-14 * (kClear / 16);
}

Envelopes::Envelopes(const GridView& view, const DualMesh& loops, const EditLog& log)
    : view_(view),
      loops_(loops),
      log_(log),
      first_loop_(view.grid.cells.size(), kNone),
      next_loop_(loops.vertices(), kNone),
      separated_(view.grid.cells.size(), 1),
      doubled_(view.grid.hits.size(), 0) {
  for (Index v = 0; v < loops.vertices(); ++v) {
    next_loop_[v] = first_loop_[loops.leaf[v]];
    first_loop_[loops.leaf[v]] = v;
  }
  find_doubled();
}

void Envelopes::find_doubled() {
  std::vector<Index> from(view_.grid.cells.size(),
                          kNone);  // the last loop with a link to this leaf
  const auto leaf_beyond = [&](Index half_edge) {
    return loops_.leaf[loops_.end_vertex(half_edge)];
  };
  const auto mark = [&](Index v, Index leaf) {
    for (const HalfEdgeId h : loops_.ring(v)) {
      if (leaf_beyond(h) != leaf) continue;
      doubled_[h / 3] = 1;
      const HalfEdgeId other = loops_.opposite[h];
      if (other != kNone) doubled_[other / 3] = 1;
    }
  };
  for (Index v = 0; v < loops_.vertices(); ++v) {
    for (const HalfEdgeId h : loops_.ring(v)) {
      const CellId leaf = leaf_beyond(h);
      if (from[leaf] == v) mark(v, leaf);
      from[leaf] = v;
    }
  }
}

// By planes that are upright on the mean normal of one of the loops.
void Envelopes::separate(const DualMesh& mesh, const HitTriangles& triangles, Index leaf) {
  const auto normal_of = [&](Index v) {
    Vec3 sum = Vec3::Zero();
    for_each_hit_of(v, [&](Index hit) { sum += view_.grid.plane_of(hit).normal; });
    return sum;
  };
  const auto parted_along = [&](const Vec3& normal) {
    std::vector<std::pair<double, double>> ranges;
    for (Index v = first_loop_[leaf]; v != kNone; v = next_loop_[v]) {
      ranges.emplace_back(std::numeric_limits<double>::max(),
                          std::numeric_limits<double>::lowest());
      for_each_hit_of(v, [&](Index hit) {
        triangles.for_each(hit, [&](Index t) {
          for (Index i = 0; i < 3; ++i) {
            const double height = normal.dot(mesh.position[mesh.vertex[3 * t + i]]);
            ranges.back().first = std::min(ranges.back().first, height);
            ranges.back().second = std::max(ranges.back().second, height);
          }
        });
      });
    }
    std::sort(ranges.begin(), ranges.end());
    for (std::size_t i = 1; i < ranges.size(); ++i) {
      if (!(ranges[i].first > ranges[i - 1].second + 4 * kClear * normal.norm())) return false;
    }
    return true;
  };
  separated_[leaf] = 0;
  for (Index v = first_loop_[leaf]; v != kNone && separated_[leaf] == 0; v = next_loop_[v]) {
    separated_[leaf] = parted_along(normal_of(v)) ? 1 : 0;
  }
}

void HitTriangles::read(const DualMesh& mesh) {
  own_.assign(hits_, 0);
  first_.assign(hits_, kNone);
  next_.assign(mesh.triangles(), kNone);
  for (Index t = 0; t < mesh.triangles(); ++t) {
    if (mesh.dropped(t)) continue;
    const Index hit = mesh.hit[t];
    if (hit == t) {
      own_[t] = 1;
    } else {
      next_[t] = first_[hit];
      first_[hit] = t;
    }
  }
}

Envelopes::Stretch Envelopes::stretch(Index hit) const {
  LatticePoint lo = view_.boxes[0].lo;
  LatticePoint hi = view_.boxes[0].hi;
  const auto narrow = [&](Index triangle) {
    for (Index h = 3 * triangle; h < 3 * triangle + 3; ++h) {
      const LatticeBox& box = view_.boxes[loops_.leaf[loops_.vertex[h]]];
      for (int i = 0; i < 3; ++i) {
        lo[i] = std::max(lo[i], box.lo[i]);
        hi[i] = std::min(hi[i], box.hi[i]);
      }
    }
  };
  narrow(hit);
  for (Index i = 0; i < 3; ++i) {
    if ((loops_.strip[hit] >> i & 1) != 0) narrow(loops_.opposite[3 * hit + i] / 3);
  }
  Stretch found;
  for (int i = 0; i < 3; ++i) {
    if (lo[i] >= hi[i]) continue;
    if (found.axis >= 0) return {};
    found = {i, static_cast<double>(lo[i]), static_cast<double>(hi[i])};
  }
  return found;
}

bool Envelopes::rim_holds(const DualMesh& mesh, Index hit) const {
  if (doubled_[hit] != 0 || log_.edited(hit)) return false;
  for (Index i = 0; i < 3; ++i) {
    const Index half_edge = 3 * hit + i;
    const Index v = loops_.vertex[half_edge];
    if (separated_[loops_.leaf[v]] == 0 || loops_.opposite[half_edge] == kNone) return false;
    const LatticeBox& box = view_.boxes[loops_.leaf[v]];
    const Vec3& p = mesh.position[v];
    for (int axis = 0; axis < 3; ++axis) {
      if (!(p[axis] > box.lo[axis] + kClear && p[axis] < box.hi[axis] - kClear)) return false;
    }
    if (((log_.links_inside_face(hit) | loops_.strip[hit]) >> i & 1) == 0) return false;
  }
  return true;
}

bool Envelopes::meets(const DualMesh& mesh, Index triangle, Index hit,
                      const Stretch& stretch) const {
  const int u = next_axis(stretch.axis);
  const int v = previous_axis(stretch.axis);
  const Vec3& edge = view_.hit_points[hit];
  double area = 0;
  double height = 0;
  double size = 0;
  for (Index i = 0; i < 3; ++i) {
    const Vec3& p = mesh.position[mesh.vertex[3 * triangle + i]];
    const Vec3& q = mesh.position[mesh.vertex[3 * triangle + (i + 1) % 3]];
    const Vec3& r = mesh.position[mesh.vertex[3 * triangle + (i + 2) % 3]];
    const double part = (q[u] - edge[u]) * (r[v] - edge[v]) - (q[v] - edge[v]) * (r[u] - edge[u]);
    area += part;
    height += part * (p[stretch.axis] - edge[stretch.axis]);
    size = std::max({size, std::abs(p[u] - edge[u]), std::abs(p[v] - edge[v]),
                     std::abs(p[stretch.axis] - edge[stretch.axis])});
  }
  if (!view_.grid.hits[hit].leaving()) {
    area = -area;
    height = -height;
  }
  if (!(area > kLeastSine * size * size)) return false;
  const double where = edge[stretch.axis] + height / area;
  return where > stretch.lo + kClear && where < stretch.hi - kClear;
}

bool Envelopes::holds(const DualMesh& mesh, const HitTriangles& triangles, Index hit) const {
  if (loops_.dropped(hit)) return true;
  if (!rim_holds(mesh, hit)) return false;
  const Stretch within = stretch(hit);
  if (within.axis < 0) return false;
  const auto all_meet = [&](Index of_hit) {
    bool all = true;
    triangles.for_each(of_hit, [&](Index t) { all = all && meets(mesh, t, of_hit, within); });
    return all;
  };
  if (!all_meet(hit)) return false;
  for (Index i = 0; i < 3; ++i) {
    if ((loops_.strip[hit] >> i & 1) == 0) continue;
    const Index partner = loops_.opposite[3 * hit + i] / 3;
    if (!rim_holds(mesh, partner) || !all_meet(partner)) return false;
  }
  return true;
}

}  // namespace kdm
