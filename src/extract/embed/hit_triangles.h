// SPDX-License-Identifier: MIT
// Lists of the triangles that stand for each hit.
#pragma once

#include <span>
#include <vector>

#include "extract/dual/dual_mesh.h"
#include "mesh/marks.h"

namespace kdm {

/// Lists the triangles of each hit: one if nothing was added round the hit, more where its triangle
/// was divided. The lists hold until triangles of the mesh are added, dropped or given to other
/// hits.
class HitTriangles {
 public:
  /// Makes empty lists for this number of hits.
  explicit HitTriangles(Index hits) : has_its_first_(hits), added_(hits, kNone), is_listed_(hits) {}

  /// Lists the triangles of these hits anew. The lists of all other hits must still hold; triangles
  /// that were added since must be of these hits. The first call must name all hits. Takes time for
  /// their triangles and for those that were added.
  void update(const DualMesh& mesh, std::span<const HitId> hits);
  /// Calls `visit(t)` for each triangle of the hit.
  template <typename Visit>
  void for_each(HitId hit, const Visit& visit) const {
    if (has_its_first_.test(hit)) visit(hit);
    for (TriangleId t = added_[hit]; t != kNone; t = next_added_[t]) visit(t);
  }

 private:
  // Triangle h stands for hit h at first; a flip may give it to another hit.
  Marks has_its_first_;                 // per hit: triangle `hit` is among its triangles
  std::vector<TriangleId> added_;       // per hit: the first in the list of its other triangles
  std::vector<TriangleId> next_added_;  // per triangle: the next one in the list that it is in
  Marks is_listed_;                     // per hit: its triangles are being listed
};

}  // namespace kdm
