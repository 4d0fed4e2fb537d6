// SPDX-License-Identifier: MIT
// Proves for single hits that their triangles cannot cross the triangles of other hits: each hit
// has a region of its own, its envelope, and its triangles lie within it. No pairs of triangles
// have to be looked at.
//
// Definitions. Let h be a hit.
//
//   S     The stretch of h: the part of h's grid edge that all leaves of h have in common.
//   v, x  Each leaf of h holds one loop of h, which has a vertex v. Between two of h's leaves lies
//         a minimal face, and across it a link leads from h to another hit; x is the point where
//         the surface passes through the face there.
//   rim   The closed polygon r0, r1, r2, ... of these points in turn: v, x, v, x, v, x. It runs
//         round the edge once, and it is the boundary of h's triangles as long as triangles were
//         only divided. Each side of it joins a v and an x and belongs to two hits, those that are
//         linked there.
//   envelope  The union of the tetrahedra (S, ri, ri+1), one over each side of the rim.
//
// Where h's edge has a strip, h is linked across it to a hit on the coinciding edge. The two have
// four leaves, one stretch and one rim, in which the strip's link has no point; their triangles
// are taken together.
//
// Conditions. For all hits:
//
//   (a) Every v lies strictly inside of its leaf, every x strictly inside of its minimal face.
//   (b) No loop has two links to one leaf.
//   (c) If a leaf holds several loops, then parallel planes part their triangles.
//
// Claim 1. Let (a) to (c) hold, and let the triangles of two hits lie in the hits' envelopes and
// touch the upper and lower sides of these, the triangles (end of S, ri, ri+1), only in the rims.
// Then the triangles of one hit and of the other have nothing in common but sides and corners of
// both rims.
//
//   1. If the hits are round different loops of one leaf, planes part all their triangles by (c).
//      Otherwise they have the same loop, and the same v, in every leaf that they share.
//   2. Each tetrahedron is spanned by S, a vertex v and a point x, which all lie in the closed leaf
//      of v. The leaf is convex, so the tetrahedron lies in it. By (a) it touches the leaf's sides
//      only in the triangle (S, x), which lies in the minimal face of x.
//   3. The two stretches have at most an end in common. For all points inside of a stretch have the
//      same leaves round them. If both hits had these leaves, they would have the same loops by
//      step 1. They are not linked to each other on all sides, since such pillows were dropped; so
//      one of the loops would have two links to one leaf, which (b) rules out.
//   4. The same holds for triangles (S, x) and (S', x') of the hits on the sides of leaves, but for
//      x. In one minimal face x = x', since two links across it would join the same two loops by
//      step 1, which (b) rules out; and from x, inside of a rectangle, its outline is seen whole.
//      So the two triangles have x in common and, where the stretches touch, the line from x to
//      their common end. In different minimal faces they meet on the outlines at most, where only
//      the stretches lie.
//   5. Tetrahedra of different leaves meet in these triangles at most. Tetrahedra of one leaf are
//      cones over them with the same apex v; a ray from v, inside of the leaf, meets the leaf's
//      sides in one point, so the cones meet on the rays from v to points that their triangles have
//      in common. By step 4 these make up the line v-x, a side of both rims, and, where the
//      stretches touch, lines and triangles that lie in upper or lower sides of the envelopes; of
//      those, the hits' triangles touch only rims.
//
// Claim 2. The triangles of h lie in its envelope, and touch its upper and lower sides only in the
// rim, if two things hold:
//
//   (d) Seen along the edge, all of them are turned the same way, as the hit is.
//   (e) The plane of each meets the line of the edge strictly inside of S.
//
//   1. Seen along the edge, the rim runs round the edge once, through one leaf after the other. By
//      (d), the number of triangles that lie over a point is the number of times that the rim runs
//      round it. So the triangles cover what lies within the rim exactly once: they are the graph
//      of a height along the edge, which is linear in pieces.
//   2. Take a ray, seen along the edge, from the edge to a point of the rim. Over it the envelope
//      is a triangle: from S to the point of the rim. Let g be the surface's height above the lower
//      side of this triangle. It is linear in pieces along the ray.
//   3. By (e) each piece, continued to the edge, is positive there.
//   4. The last piece is zero on the rim and positive on the edge, so it is positive in between,
//      also where it begins. The piece before it ends with this value and is positive on the edge,
//      so it is positive throughout; and so on inwards, piece by piece.
//   5. The same holds for the distance to the upper side. Hence the surface over the ray lies in
//   the
//      envelope, strictly between its upper and its lower side but for the point of the rim.
//
// Neither how many triangles a hit has nor which they are plays a part in this.
//
// What is tested, with room for rounding (`kClear` is 1/32 lattice unit, `kLeastSine` 1/4096):
//
//   (a) v lies more than kClear off all sides of its leaf. Of x the log says that it lies inside of
//       its face, found with the same margin when the link was placed.
//   (b) exactly, from the links.
//   (c) for planes whose normal is the sum of the hits' normals of one loop of the leaf: between
//       the triangles of two loops lies a gap of more than 4 kClear, an eighth of a lattice unit.
//   (d) twice the area of each triangle, seen along the edge, is greater than kLeastSine times the
//       square of its extent about the hit.
//   (e) the plane meets the edge more than kClear from the ends of S.
//   And the hit's triangles were only divided: its rim is that of the definition.
//
// A hit that fails a test may still keep clear of all others; nothing is known about it.
#pragma once

#include <vector>

#include "extract/dual/edit_log.h"
#include "extract/dual/grid_view.h"
#include "extract/embed/hit_triangles.h"
#include "mesh/marks.h"

namespace kdm {

/// Tells whether double precision is enough for the tests above, margins included. It is not enough
/// where the model lies some thousand times its size away from the origin.
bool double_precision_suffices(const Lattice& lattice);

/// Tests the hits of a mesh. Refers to the grid, to `loops`, the mesh of one triangle a hit from
/// which the mesh was made, with the loops of leaves found (`find_loops_of_leaves`), and to `log`,
/// which says what was done to it since.
class Envelopes {
 public:
  /// Takes loops of one leaf as parted until `update_leaf` finds them otherwise.
  Envelopes(const GridView& view, const DualMesh& loops, const EditLog& log);

  /// Finds anew whether parallel planes part the triangles round the loops of a leaf (condition c).
  /// To be called when triangles round loops of a leaf that `has_several_loops` have changed.
  void update_leaf(const DualMesh& mesh, const HitTriangles& triangles, CellId leaf);

  /// Tells whether all conditions above hold for the hit, so that its triangles cannot meet the
  /// triangles of other hits for which all conditions hold. A dropped hit has no triangles and is
  /// enclosed.
  bool enclose(const DualMesh& mesh, const HitTriangles& triangles, HitId hit) const;

  bool has_several_loops(CellId leaf) const {
    const LoopId v = loop_in_leaf_[leaf];
    return v != kNone && loops_.next_loop_in_leaf[v] != v;
  }

  /// Calls `visit(v)` for each loop of the leaf.
  template <typename Visit>
  void for_each_loop(CellId leaf, const Visit& visit) const {
    const LoopId first = loop_in_leaf_[leaf];
    if (first == kNone) return;
    LoopId v = first;
    do {
      visit(v);
      v = loops_.next_loop_in_leaf[v];
    } while (v != first);
  }

  /// Calls `visit(hit)` for the hits round each loop of the leaf.
  template <typename Visit>
  void for_each_hit(CellId leaf, const Visit& visit) const {
    for_each_loop(leaf, [&](LoopId v) { for_each_hit_round(v, visit); });
  }

 private:
  // A part of a grid edge, in lattice units along its axis.
  struct Stretch {
    int axis = -1;  // -1: there is none
    double lo = 0;
    double hi = 0;
  };

  template <typename Visit>
  void for_each_hit_round(LoopId v, const Visit& visit) const {
    for (const HalfEdgeId h : loops_.ring(v)) visit(h / 3);
  }

  void find_doubled_links();
  void mark_links_to(CellId leaf, LoopId v);
  Vec3 normal_of(LoopId v) const;
  bool parted_along(const Vec3& normal, const DualMesh& mesh, const HitTriangles& triangles,
                    CellId leaf) const;
  Stretch stretch_of(HitId hit) const;
  bool rim_is_sound(const DualMesh& mesh, HitId hit) const;
  bool passes_through(const Stretch& stretch, const DualMesh& mesh, TriangleId triangle,
                      HitId hit) const;

  GridView view_;
  const DualMesh& loops_;
  const EditLog& log_;
  std::vector<LoopId> loop_in_leaf_;  // per cell: a loop that lies in it, or kNone
  Marks not_parted_;                  // per cell: planes do not part its loops' triangles
  Marks has_doubled_link_;            // per hit: a loop has two links to one leaf, one of them here
};

}  // namespace kdm
