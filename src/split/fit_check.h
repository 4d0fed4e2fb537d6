// SPDX-License-Identifier: MIT
// The fit test: would a cell that stays a leaf meet the surface within the tolerance?
//
// A leaf gives each piece of the surface in it one vertex, where the squared distances to the
// planes of the piece's hits have their least sum. The piece fits if
// - every corner of its triangles, cut to the cell, lies within the tolerance of one of these
//   planes,
// - the vertex lies within the tolerance of the planes of all of the piece's triangles, since
//   splits of neighbouring cells may yet put hits on any of them,
// - the vertex lies within the tolerance of the piece itself, and near one of its sharp edges if it
//   lies beside any.
// At the rim of a surface the vertex belongs on the rim: the planes that stand upright on the
// surface along the rim count like those of hits.
#pragma once

#include <optional>
#include <vector>

#include "split/cell_surface.h"
#include "split/planned_hits.h"

namespace kdm {

/// Who gets the vertices of a leaf.
enum class LeafVertices {
  kOneEachPiece,
  kOneForAll  ///< where shells cross, their pieces bound the solid together
};

/// Tests cell after cell. All lengths are lattice units.
class FitCheck {
 public:
  FitCheck(const Surface& surface, double tolerance) : FitCheck(surface, tolerance, tolerance) {}
  /// Where one vertex stands for all pieces it must fit them within `shared_tolerance`.
  FitCheck(const Surface& surface, double tolerance, double shared_tolerance)
      : surface_(surface), tolerance_(tolerance), shared_tolerance_(shared_tolerance) {}

  /// Plans the hits of the cell that is tested next.
  void plan_hits(const LatticeBox& box, const CellCrossings& crossings) {
    hits_.plan(surface_, box, crossings);
    joint_vertex_.reset();
  }

  /// Tells whether a vertex of the surface within the cell lies off the planes of all planned hits,
  /// or all hits are sure to be of one piece and its vertex lies off one of their planes, so that
  /// the cell cannot fit however its pieces lie; or whether surface lies in the cell that has no
  /// crossings at all. This is cheap, because no pieces are needed. An answer "no" promises
  /// nothing. Cells with crossings but without hits are never called misfits: all that is in them
  /// may lie within another shell.
  bool is_clear_misfit(const LatticeBox& box, std::span<const ListEntry> entries,
                       const CellCrossings& crossings);

  /// Tells whether all pieces with hits fit. Pieces without hits get no vertex: they are left to
  /// the topology test.
  bool pieces_fit(const CellSurface& cell, LeafVertices vertices);

 private:
  bool joint_vertex_misses(const LatticeBox& box, const CellCrossings& crossings);
  bool piece_fits_vertex(const CellSurface& cell, PieceId piece);
  static bool bounds_solid(const CellSurface& cell, MemberId member);
  static bool nothing_bounds(const CellSurface& cell);
  bool corners_meet_planes(const CellSurface& cell, LeafVertices vertices);
  void find_triangles(const CellSurface& cell, PieceId piece);
  void find_rim(const CellSurface& cell, PieceId piece);
  Vec3 planned_vertex(const LatticeBox& box, PieceId piece) const;
  bool is_near_planes(const Vec3& vertex) const;
  bool is_near_triangles(const Vec3& vertex) const;
  bool is_near_sharp_edge(const Vec3& vertex, const CellSurface& cell) const;

  const Surface& surface_;
  double tolerance_;
  double shared_tolerance_;
  double limit_ = 0;  // the one of the two that counts
  PlannedHits hits_;
  std::optional<Vec3> joint_vertex_;  // of the piece that has all hits, if it is known already
  // Of the piece whose vertex is tested:
  std::vector<TriangleId> triangles_;
  std::vector<Plane> rim_planes_;
  Vec3 rim_centre_ = Vec3::Zero();
};

}  // namespace kdm
