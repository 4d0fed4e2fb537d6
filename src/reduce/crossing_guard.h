// SPDX-License-Identifier: MIT
// Keeps a mesh from meeting itself while its edges are collapsed and flipped.
#pragma once

#include <array>
#include <vector>

#include "geometry/fan.h"
#include "mesh/marks.h"
#include "reduce/half_edges.h"
#include "reduce/ring.h"
#include "reduce/triangle_tree.h"

namespace kdm {

/// Tests triangles that a step would make against each other and against all that are near. Exact,
/// for coordinates of about 1.
class CrossingGuard {
 public:
  class Scratch;

  CrossingGuard(const HalfEdges& mesh, const std::vector<Vec3>& positions);

  /// Tells whether a triangle of the ring would be without area, or meet another one of the ring or
  /// of the rest of the mesh where they share neither vertex nor edge.
  bool would_meet(const CollapseRing& ring, Scratch& scratch);
  /// Tells the same of two triangles that are to take the place of others, given by numbers.
  bool would_meet(const std::array<TriangleId, 2>& places, const std::array<Triangle, 2>& triangles,
                  Scratch& scratch);

  /// Tells whether the ring's triangles surely meet neither each other nor what shares a vertex
  /// with them: what is cheap to know. An answer "no" promises nothing.
  bool is_simple_all_round(const CollapseRing& ring, Scratch& scratch) const;

  /// Makes known that a triangle's corners are others now, or that it is gone.
  void changed(TriangleId t);

 private:
  struct Planned {
    Triangle numbers;
    std::array<Vec3, 3> corners;
    SmallBox box;
    Vec3 doubled_area;
  };

  bool is_simple(const CollapseRing& ring, Scratch& scratch) const;
  bool is_simple(const CollapseRing& ring, VertexId v, Scratch& scratch) const;
  bool planned_meet(const Scratch& scratch, bool simple_inside, TriangleId beside);
  bool surely_beside(const Planned& t, const Triangle& other) const;
  bool surely_beyond(const Planned& t, const Vec3& normal, double size, const Vec3& origin,
                     const Triangle& other) const;
  bool meets(const Planned& triangle, TriangleId other) const;
  void catch_up();

  const HalfEdges& mesh_;
  const std::vector<Vec3>& positions_;
  TriangleTree tree_;  // as it was before the triangles put off were changed
  Marks is_put_off_;   // per triangle
  std::vector<TriangleId> put_off_;
  Index rebuild_below_ = 0;  // living triangles at which the tree is built anew
};

/// What a test writes down while it lasts.
class CrossingGuard::Scratch {
 public:
  explicit Scratch(const HalfEdges& mesh) : replaced_(mesh.triangles()), simple_(mesh.vertices()) {}

 private:
  friend class CrossingGuard;

  void plan(const Triangle& numbers, const std::array<Vec3, 3>& corners);
  bool surely_apart(const Planned& t, const Triangle& other) const;

  Marks replaced_;  // per triangle: takes no part, because a planned one replaces it
  std::vector<Planned> planned_;
  // Per vertex: the triangles that there would be round it surely do not meet.
  Marks simple_;
  std::vector<OuterSide> sides_;
};

}  // namespace kdm
