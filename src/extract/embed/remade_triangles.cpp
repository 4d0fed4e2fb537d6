// SPDX-License-Identifier: MIT
// Goes through the triangles of each hit, before and now, side by side.
#include "extract/embed/remade_triangles.h"

#include <algorithm>
#include <numeric>

namespace kdm {

void RemadeTriangles::compare(const DualMesh& mesh, const HitTriangles& triangles,
                              std::span<const HitId> hits) {
  now_.resize(vertex_.size() / 3);
  std::iota(now_.begin(), now_.end(), TriangleId{0});
  vertex_now_.assign(position_.size(), kNone);
  vertex_before_.assign(mesh.vertices(), kNone);
  const bool first = now_.empty();
  for (const HitId hit : hits) {
    old_.clear();
    new_.clear();
    if (!first) triangles_.for_each(hit, [&](TriangleId t) { old_.push_back(t); });
    triangles.for_each(hit, [&](TriangleId t) { new_.push_back(t); });
    as_before_.set(hit, !first && has_same(mesh));
    for (std::size_t i = 0; i < old_.size(); ++i) {
      now_[old_[i]] = as_before_.test(hit) ? new_[i] : kNone;
    }
  }
  triangles_ = triangles;
  vertex_ = mesh.vertex;
  position_ = mesh.position;
}

// Tells whether the hit's triangles have the same corners as before.
bool RemadeTriangles::has_same(const DualMesh& mesh) {
  if (old_.size() != new_.size()) return false;
  for (std::size_t i = 0; i < old_.size(); ++i) {
    for (Index k = 0; k < 3; ++k) {
      const Vec3& before = position_[vertex_[3 * old_[i] + k]];
      if (mesh.position[mesh.vertex[3 * new_[i] + k]] != before) return false;
    }
  }
  return pair_corners(mesh);
}

// Notes which vertices now stand for which before. Returns false if that contradicts what was
// noted.
bool RemadeTriangles::pair_corners(const DualMesh& mesh) {
  for (std::size_t i = 0; i < old_.size(); ++i) {
    for (Index k = 0; k < 3; ++k) {
      const VertexId before = vertex_[3 * old_[i] + k];
      const VertexId now = mesh.vertex[3 * new_[i] + k];
      if (now < position_.size() || mesh.first_half_edge[before] != kNone) {
        if (now != before) return false;
        continue;
      }
      if (vertex_now_[before] == kNone && vertex_before_[now] == kNone) {
        vertex_now_[before] = now;
        vertex_before_[now] = before;
      }
      if (vertex_now_[before] != now || vertex_before_[now] != before) return false;
    }
  }
  return true;
}

}  // namespace kdm
