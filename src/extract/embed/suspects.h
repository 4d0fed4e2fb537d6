// SPDX-License-Identifier: MIT
// Finds the suspects: the triangles of a mesh that may cross others at all.
//
// A hit is enclosed if all of its triangles lie in the hit's envelope (envelope.h). Triangles of
// two enclosed hits never cross. The triangles of all hits that are not enclosed are suspects: only
// pairs with a suspect have to be tested.
#pragma once

#include <span>
#include <vector>

#include "extract/embed/envelope.h"

namespace kdm {

/// Knows which hits are enclosed, and keeps this up to date while a mesh changes.
class Suspects {
 public:
  /// `loops` is the mesh of one triangle a hit from which the mesh was made, `log` says what was
  /// done to it since. Both must outlive this object. No hit is enclosed before the first `update`.
  Suspects(const GridView& view, const DualMesh& loops, const EditLog& log);

  /// Finds anew which hits are enclosed, after the triangles of the `changed` hits were changed;
  /// the first call must name all hits. Returns, ascending, the hits whose answers may differ from
  /// before: the changed hits, the hits across strips from them, and the hits round loops in leaves
  /// that they share with a changed hit and with another loop. Valid until the next update. Takes
  /// time linear in the number of triangles, with a small factor.
  const std::vector<HitId>& update(const DualMesh& mesh, std::span<const HitId> changed);

  /// Tells whether the triangles of the hit lie in its envelope; if not, they are suspects.
  bool is_enclosed(HitId hit) const { return enclosed_.test(hit); }
  /// Lists the triangles of each hit, as of the last update.
  const HitTriangles& triangles() const { return triangles_; }
  /// Calls `visit(t)` for each triangle of the hit, as of the last update.
  template <typename Visit>
  void for_each_triangle(HitId hit, const Visit& visit) const {
    triangles_.for_each(hit, visit);
  }
  /// Calls `visit(t)` for each triangle of an enclosed hit that may lie in the leaf, for some of
  /// them twice.
  template <typename Visit>
  void for_each_enclosed_triangle(CellId leaf, const Visit& visit) const;

 private:
  void find_hits_to_update(std::span<const HitId> changed);
  std::vector<CellId> leaves_of_several_loops(std::span<const HitId> hits) const;

  const DualMesh& loops_;
  Envelopes envelopes_;
  HitTriangles triangles_;
  bool precise_;                     // double precision is enough for the test of envelopes
  Marks enclosed_;                   // per hit
  Marks updated_;                    // per hit: among `updated_hits_`
  std::vector<HitId> updated_hits_;  // what the last update returned
};

template <typename Visit>
void Suspects::for_each_enclosed_triangle(CellId leaf, const Visit& visit) const {
  envelopes_.for_each_hit(leaf, [&](HitId hit) {
    if (!is_enclosed(hit)) return;
    for_each_triangle(hit, visit);
    // The envelope of two hits across a strip is one, and lies in the leaves of both.
    for (Index i = 0; i < 3; ++i) {
      if ((loops_.strip[hit] >> i & 1) == 0) continue;
      for_each_triangle(loops_.opposite[3 * hit + i] / 3, visit);
    }
  });
}

}  // namespace kdm
