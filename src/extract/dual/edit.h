// SPDX-License-Identifier: MIT
// New vertices on the edges and in the triangles of a dual mesh.
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

/// The same for an edge on the boundary, with triangle (a, b, c) alone.
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
  std::vector<Index> where_;   // per half-edge of before: which it is now
  std::vector<Index> origin_;  // per half-edge: which it was before, or kNone
};

}  // namespace kdm
