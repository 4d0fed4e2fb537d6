// SPDX-License-Identifier: MIT
// Adds vertices on the edges and in the triangles of a dual mesh.
#pragma once

#include <span>

#include "extract/dual/dual_mesh.h"

namespace kdm {

/// Divides edge a-b and the triangles (a, b, c) and (b, a, d) on its sides. Half-edge `ab` becomes
/// a-m, its opposite b-m. Returns m.
///
///        c                 c
///      / . \             / | \        .
///     a-----b    ->     a--m--b
///      \ . /             \ | /
///        d                 d
Index divide_edge(Index ab, const Vec3& position, DualMesh& mesh);

/// Divides edge a-b on the boundary and its only triangle (a, b, c). Half-edge `ab` becomes a-m.
/// Returns m.
Index divide_boundary(Index ab, const Vec3& position, DualMesh& mesh);

/// Divides triangle (a, b, c) into (a, b, m), which keeps its number, (b, c, m) and (c, a, m).
/// Returns m.
Index divide_triangle(Index triangle, const Vec3& position, DualMesh& mesh);

/// A vertex m on edge a-b that belongs to the triangles on one side only: on the other side edge
/// a-b is whole. `opposite` leads from a-b to m-a, and from m-a and b-m to a-b: the rings round a
/// and b are closed, that round m is not.
struct OneSidedVertex {
  VertexId vertex;       ///< m
  HalfEdgeId half_edge;  ///< a-b
  HalfEdgeId opposite;   ///< b-a, where neither side is divided
  HalfEdgeId from_end;   ///< b-m
  HalfEdgeId to_start;   ///< m-a
};

/// Divides many triangles and edges, which are named as they were before the first division. The
/// mesh must not be open.
class Division {
 public:
  /// `one_sided` are the vertices for which `side` will be called.
  explicit Division(DualMesh& mesh, std::span<const OneSidedVertex> one_sided = {});

  void triangle(Index triangle, const Vec3& position);
  void edge(Index half_edge, const Vec3& position);
  /// Divides edge a-b and its triangle at the vertex that the other side has there.
  void side(const OneSidedVertex& m);

 private:
  void moved(Index from, Index to);

  DualMesh& mesh_;
  std::vector<HalfEdgeId> where_;   // its present number, per half-edge before the first division
  std::vector<HalfEdgeId> origin_;  // its number before the first division or kNone, per half-edge
};

}  // namespace kdm
