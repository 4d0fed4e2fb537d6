// SPDX-License-Identifier: MIT
// Adds vertices on the edges and in the triangles of a dual mesh.
#pragma once

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

/// Divides many triangles and edges, which are named as they were before the first division.
class Division {
 public:
  explicit Division(DualMesh& mesh);

  void triangle(Index triangle, const Vec3& position);
  void edge(Index half_edge, const Vec3& position);

 private:
  void moved(Index from, Index to);

  DualMesh& mesh_;
  std::vector<HalfEdgeId> where_;   // its present number, per half-edge before the first division
  std::vector<HalfEdgeId> origin_;  // its number before the first division or kNone, per half-edge
};

}  // namespace kdm
