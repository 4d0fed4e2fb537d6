// SPDX-License-Identifier: MIT
// Makes a linked list of triangles for each hit.
#include "extract/embed/hit_triangles.h"

#include "mesh/sort.h"

namespace kdm {

// A triangle of theirs is one of those that the hits had before, or their first one, which was
// dropped and is there again, or was added since.
void HitTriangles::update(const DualMesh& mesh, std::span<const HitId> hits) {
  std::vector<TriangleId> triangles;
  for (const HitId hit : hits) for_each(hit, [&](TriangleId t) { triangles.push_back(t); });
  for (const HitId hit : hits) {
    has_its_first_.clear(hit);
    added_[hit] = kNone;
    is_listed_.set(hit);
  }
  const auto before = static_cast<TriangleId>(next_added_.size());
  for (const HitId hit : hits) triangles.push_back(hit);
  for (TriangleId t = before; t < mesh.triangles(); ++t) triangles.push_back(t);
  make_set(triangles);
  next_added_.resize(mesh.triangles(), kNone);
  for (const TriangleId t : triangles) {
    const HitId hit = mesh.hit[t];
    if (mesh.dropped(t) || !is_listed_.test(hit)) continue;
    if (hit == t) {
      has_its_first_.set(t);
    } else {
      next_added_[t] = added_[hit];
      added_[hit] = t;
    }
  }
  for (const HitId hit : hits) is_listed_.clear(hit);
}

}  // namespace kdm
