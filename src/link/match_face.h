// SPDX-License-Identifier: MIT
// Pairs the hits round one minimal face: by one rule for solids, by another one for sheets.
#pragma once

#include <span>
#include <vector>

#include "kdmanifold/build.h"
#include "link/outline.h"
#include "link/tangents.h"
#include "link/trace.h"
#include "prepare/surface.h"

namespace kdm {

/// Which hits of an outline belong together.
struct FaceMatch {
  std::vector<Index> partner;  ///< per hit: the place of its partner in the outline, or kNone
  std::vector<RimHit> rims;    ///< where the surface ends within the face; in no order
  bool guessed = false;        ///< the surface was traced, but traces did not decide all pairs
};

/// Pairs all hits of a solid's face. If there are just two hits, they are a pair. If there are
/// more, several pairings would make the result manifold, and the geometry tells which is right
/// (paper 2.1): first the pairs are made that traces across the surface find (link/trace.h), then
/// pairs with the least deviation from the hits' tangents (link/tangents.h). The half-edges of a
/// pair run in opposite directions across the face, and pairs do not cross.
class SolidMatcher {
 public:
  /// Refers to the surface, to the grid and to the numbers of the triangles that make its hits.
  SolidMatcher(const Surface& surface, std::span<const TriangleId> triangle_of_hit, Pairing pairing,
               const GridData& grid)
      : surface_(surface), triangle_of_hit_(triangle_of_hit), pairing_(pairing), grid_(grid) {}

  /// Throws if the half-edges that lead upwards across the face are not as many as those that lead
  /// downwards. Takes time cubic in the number of hits; linear if there are more than 256, where
  /// neighbours are paired.
  void operator()(const MinimalFace& face, const std::vector<OutlineHit>& outline,
                  FaceMatch& match);

 private:
  void pair_hits(const MinimalFace& face, const std::vector<OutlineHit>& outline, FaceMatch& match);
  bool enters(const OutlineHit& h) const;
  Index stretch_inside(const std::vector<OutlineHit>& outline, Index i, Index j) const;
  std::vector<Index> pair_neighbours(const std::vector<OutlineHit>& outline, bool inside) const;
  void keep_rims(const MinimalFace& face, const std::vector<OutlineHit>& outline, FaceMatch& match);

  const Surface& surface_;
  std::span<const TriangleId> triangle_of_hit_;
  Pairing pairing_;
  const GridData& grid_;
  std::vector<Traced> traces_;  // per hit of the outline
  std::vector<Tangent> tangents_;
};

/// Pairs hits of a sheet's face as far as they belong together (paper 2.3.2). The surface's section
/// with the face runs from hit to hit, or from a hit to the rim: the first two are paired, the last
/// one stays alone, and the point where the rim passes through the face is kept, because the
/// vertices at both ends of the boundary edge belong on the rim. Round a sheet's face, half-edges
/// of the same direction may follow each other. Pairs found by traces may cross: they do where the
/// input crosses itself. Hits that no trace decides are paired at the least deviation, as many as
/// possible and without crossings; so are two hits whose traces end at rims that lie within
/// rounding of each other, because such rims are a crack of the input.
class SheetMatcher {
 public:
  /// Refers to the surface, to the grid and to the numbers of the triangles that make its hits.
  SheetMatcher(const Surface& surface, std::span<const TriangleId> triangle_of_hit, Pairing pairing,
               const GridData& grid)
      : surface_(surface), triangle_of_hit_(triangle_of_hit), pairing_(pairing), grid_(grid) {}

  /// Takes time cubic in the number of hits; linear if there are more than 256.
  void operator()(const MinimalFace& face, const std::vector<OutlineHit>& outline,
                  FaceMatch& match);

 private:
  void trace_all(const MinimalFace& face, const std::vector<OutlineHit>& outline, FaceMatch& match);
  void match_rest(const MinimalFace& face, const std::vector<OutlineHit>& outline,
                  FaceMatch& match);
  bool may_pair(const OutlineHit& a, const OutlineHit& b, const RimHit& rim_of_a,
                const RimHit& rim_of_b) const;

  const Surface& surface_;
  std::span<const TriangleId> triangle_of_hit_;
  Pairing pairing_;
  const GridData& grid_;
  std::vector<Traced> traces_;  // per hit of the outline
  std::vector<RimHit> rims_;    // per hit of the outline; its half-edge is kNone if there is none
  std::vector<Index> open_;     // places of the hits that no trace decided
  std::vector<Tangent> tangents_;
};

}  // namespace kdm
