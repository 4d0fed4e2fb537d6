// SPDX-License-Identifier: MIT
// Finds the triangles that a mesh has again after a part of it was made anew.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "extract/embed/hit_triangles.h"

namespace kdm {

/// Compares a mesh with what it was at the last comparison. A hit is as before if its triangles
/// are: with the same corners at the same places, only numbered differently. Vertices are numbered
/// differently too where they were dropped and made again. Corners of two hits that are as before
/// are one vertex exactly if they were one before.
class RemadeTriangles {
 public:
  /// Remembers a mesh without triangles. `hits` is how many hits there are.
  explicit RemadeTriangles(Index hits) : triangles_(hits), as_before_(hits) {}

  /// Finds which of these hits are as before, and remembers the mesh as it is now. The triangles of
  /// all other hits must be what they were; the first call must name all hits. `triangles` lists
  /// the mesh's triangles by hit. Takes time for the hits, and for what was added to the mesh.
  void compare(const DualMesh& mesh, const HitTriangles& triangles, std::span<const HitId> hits);

  /// Tells whether the hit was as before in the last comparison, of those that it was given.
  bool as_before(HitId hit) const { return as_before_.test(hit); }
  /// Returns the number that a triangle has since the last comparison, which had another one before
  /// it; kNone if its hit was not as before.
  TriangleId now(TriangleId before) const { return now_[before]; }

 private:
  void forget_pairs();
  bool has_same(const DualMesh& mesh);
  bool pair_corners(const DualMesh& mesh);
  void remember(const DualMesh& mesh, std::span<const HitId> hits);

  HitTriangles triangles_;             // of the mesh that is remembered
  std::vector<VertexId> vertex_;       // its corners
  std::vector<Vec3> position_;         // of its vertices
  Marks as_before_;                    // per hit
  std::vector<TriangleId> now_;        // per triangle of the mesh that was remembered
  std::vector<TriangleId> other_now_;  // those for which that is not their own number
  // Per vertex that was made again: its other number. Vertices that stay have their own.
  std::vector<VertexId> vertex_now_;
  std::vector<VertexId> vertex_before_;
  std::vector<std::pair<VertexId, VertexId>> pairs_;  // of vertices, before and now
  std::vector<TriangleId> old_;  // the triangles of the hit that is looked at, before
  std::vector<TriangleId> new_;  // and now
};

}  // namespace kdm
