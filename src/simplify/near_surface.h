// SPDX-License-Identifier: MIT
// Whether a vertex that loops become keeps the surface near to what it was, both ways, and turned
// as its hits are.
#pragma once

#include "kdmanifold/mesh.h"
#include "reduce/reference.h"
#include "reduce/samples.h"
#include "simplify/removal.h"

namespace kdm {

/// The distance that is kept. Triangles have the numbers of their hits.
class NearSurface {
 public:
  /// `reference` is the mesh to stay near to, in model units; `distance` is in lattice units.
  NearSurface(const WorkGrid& work, const Mesh& reference, double distance);

  /// Looks for a position of the piece's vertex, within the box, such that the new vertex and
  /// points spread over the new triangles are near to the reference, the samples of the triangles
  /// find a place at the new ones, and none of these is turned over. Tries the point with the least
  /// squared distances to all planes that the vertex stands for, then where the loops' vertices
  /// are. Returns whether there is one.
  bool find_position(const WorkGrid& work, const JoinedPiece& piece, const LatticeBox& box,
                     Vec3& position);
  /// Moves the samples to the triangles round the piece's vertex at a position that was found.
  void move(const WorkGrid& work, const JoinedPiece& piece, const Vec3& position);

 private:
  bool fits(const WorkGrid& work);
  bool is_near(const RingTriangle& t, TriangleId hint);

  double distance_;
  Reference reference_;
  Samples samples_;
  Samples::Places places_;   // where they would go
  TriangleId near_ = kNone;  // the triangle of the reference that was found last
  CollapseRing ring_;        // of the piece that is looked at
};

}  // namespace kdm
