// SPDX-License-Identifier: MIT
// Which hits' triangles cannot meet those of others: a test of each alone, without pairs.
//
// Round the stretch S of grid edge that a hit's leaves have in common lie, in turn, the vertices of
// their loops and the points where the links to the next hits go through the minimal faces: its
// rim r0, r1, ... The tetrahedra (S, ri, ri+1) are the hit's envelope. Each lies in one leaf and is
// made of a loop's vertex v, a link's point x and S, and two hits' envelopes have but rim edges
// v-x in common, if every v lies inside of its leaf, every x inside of its minimal face, no leaf
// has two loops and no loop two links to one leaf: seen from v, (S, x) are triangles on the leaf's
// sides, of which those of one face have only x in common, since x sees its outline whole. Where a
// leaf has several loops, planes must part the triangles round them; triangles that meet on a face
// are round the same loop on one side of it or the other, or parted there.
//
// The hit's triangles lie in the envelope if, seen along the edge, all are turned rightly, so that
// they cover what lies within the rim once, and the plane of each meets the edge within S. For
// along a ray from the edge to a point of the rim, their height above the envelope's lower side is
// linear in pieces, each of which continues to a height above it at the edge, and the last one
// ends on the rim; so from there inwards none begins below, and the same holds for the upper side.
// It matters neither how many triangles there are nor which. Across a strip two hits have four
// leaves, one S, and one rim.
//
// All this is tested with room for rounding.
#pragma once

#include "extract/dual/clearance.h"
#include "extract/dual/dual_mesh.h"
#include "extract/dual/edit_log.h"
#include "extract/dual/grid_view.h"

namespace kdm {

/// Is double precision enough for the above? Not where the model is some thousand times its size
/// off the origin.
bool rounds_little(const Lattice& lattice);

/// The triangles of every hit of a mesh.
class HitTriangles {
 public:
  explicit HitTriangles(Index hits) : hits_(hits) {}

  /// Reads them anew.
  void read(const DualMesh& mesh);
  /// Calls `visit(t)` for each.
  template <typename Visit>
  void for_each(Index hit, const Visit& visit) const {
    if (own_[hit] != 0) visit(hit);
    for (Index t = first_[hit]; t != kNone; t = next_[t]) visit(t);
  }

 private:
  Index hits_;
  std::vector<char> own_;     // per hit: the triangle of its number is its own, flips exchange them
  std::vector<Index> first_;  // per hit: of a list of the others
  std::vector<Index> next_;   // per triangle
};

/// The test for the hits of a mesh. `loops` is what it was made from: one triangle a hit. `log`
/// says what was done to it since.
class Envelopes {
 public:
  Envelopes(const GridView& view, const DualMesh& loops, const EditLog& log);

  /// Finds anew whether the triangles round the loops of a leaf keep to sides of planes.
  void separate(const DualMesh& mesh, const HitTriangles& triangles, Index leaf);

  /// Do the hit's triangles lie in its envelope, those of other loops in its leaves apart?
  bool holds(const DualMesh& mesh, const HitTriangles& triangles, Index hit) const;

  bool has_several_loops(Index leaf) const {
    return first_loop_[leaf] != kNone && next_loop_[first_loop_[leaf]] != kNone;
  }

  /// Calls `visit(hit)` for the hits round each loop of the leaf.
  template <typename Visit>
  void for_each_hit(Index leaf, const Visit& visit) const {
    for (Index v = first_loop_[leaf]; v != kNone; v = next_loop_[v]) for_each_hit_of(v, visit);
  }

 private:
  struct Stretch {
    int axis = -1;  // -1: none
    double lo = 0;
    double hi = 0;
  };

  template <typename Visit>
  void for_each_hit_of(Index loop, const Visit& visit) const {
    for (const HalfEdgeId h : loops_.ring(loop)) visit(h / 3);
  }

  void find_doubled();
  Stretch stretch(Index hit) const;
  bool rim_holds(const DualMesh& mesh, Index hit) const;
  bool meets(const DualMesh& mesh, Index triangle, Index hit, const Stretch& stretch) const;

  GridView view_;
  const DualMesh& loops_;
  const EditLog& log_;
  std::vector<Index> first_loop_;  // per leaf
  std::vector<Index> next_loop_;   // per loop: in the same leaf
  std::vector<char> separated_;    // per leaf: its loops' triangles are
  std::vector<char> doubled_;      // per hit: a loop of its has two links to one leaf
};

}  // namespace kdm
