// SPDX-License-Identifier: MIT
// Makes a linked list of triangles for each hit.
#include "extract/embed/hit_triangles.h"

namespace kdm {

void HitTriangles::read(const DualMesh& mesh) {
  has_its_first_.assign(hits_);
  added_.assign(hits_, kNone);
  next_added_.assign(mesh.triangles(), kNone);
  for (TriangleId t = 0; t < mesh.triangles(); ++t) {
    if (mesh.dropped(t)) continue;
    const HitId hit = mesh.hit[t];
    if (hit == t) {
      has_its_first_.set(t);
    } else {
      next_added_[t] = added_[hit];
      added_[hit] = t;
    }
  }
}

}  // namespace kdm
