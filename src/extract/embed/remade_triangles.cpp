// SPDX-License-Identifier: MIT
// Goes through the triangles of each hit, before and now, side by side.
#include "extract/embed/remade_triangles.h"

namespace kdm {

void RemadeTriangles::compare(const DualMesh& mesh, const HitTriangles& triangles,
                              std::span<const HitId> hits) {
  const bool first = vertex_.empty();
  forget_pairs();
  vertex_before_.resize(mesh.vertices(), kNone);
  for (const HitId hit : hits) {
    old_.clear();
    new_.clear();
    if (!first) triangles_.for_each(hit, [&](TriangleId t) { old_.push_back(t); });
    triangles.for_each(hit, [&](TriangleId t) { new_.push_back(t); });
    as_before_.set(hit, !first && has_same(mesh));
    for (std::size_t i = 0; i < old_.size(); ++i) {
      const TriangleId t = as_before_.test(hit) ? new_[i] : kNone;
      if (t == old_[i]) continue;
      now_[old_[i]] = t;
      other_now_.push_back(old_[i]);
    }
  }
  remember(mesh, hits);
}

// Makes ready for the next comparison: all that was there has its own number, and what was added
// since the last one has, too.
void RemadeTriangles::forget_pairs() {
  for (const TriangleId t : other_now_) now_[t] = t;
  other_now_.clear();
  for (const auto& [before, now] : pairs_) {
    vertex_now_[before] = kNone;
    vertex_before_[now] = kNone;
  }
  pairs_.clear();
  for (auto t = static_cast<TriangleId>(now_.size()); 3 * t < vertex_.size(); ++t) {
    now_.push_back(t);
  }
  vertex_now_.resize(position_.size(), kNone);
}

// Remembers the triangles of these hits; all others are remembered already.
void RemadeTriangles::remember(const DualMesh& mesh, std::span<const HitId> hits) {
  triangles_.update(mesh, hits);
  vertex_.resize(mesh.vertex.size(), kNone);
  position_.resize(mesh.position.size());
  for (const HitId hit : hits) {
    triangles_.for_each(hit, [&](TriangleId t) {
      for (HalfEdgeId h = 3 * t; h < 3 * t + 3; ++h) {
        vertex_[h] = mesh.vertex[h];
        position_[mesh.vertex[h]] = mesh.position[mesh.vertex[h]];
      }
    });
  }
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
        pairs_.emplace_back(before, now);
      }
      if (vertex_now_[before] != now || vertex_before_[now] != before) return false;
    }
  }
  return true;
}

}  // namespace kdm
