// SPDX-License-Identifier: MIT
// Links half-edges across minimal faces: walks over all faces once, and asks a matcher for the
// pairs of each.
#include "link/link.h"

#include <vector>

#include "geometry/assert.h"
#include "grid/links.h"
#include "link/match_face.h"
#include "link/outline.h"
#include "link/rim_hits.h"

namespace kdm {
namespace {

// The two long sides of a strip coincide: their hits are the same crossings of the surface, which
// are linked one to one.
void link_strip(const MinimalFace& face, GridData& grid) {
  const auto [a, b] = long_sides(face);
  KDM_ASSERT(a.hits.size() == b.hits.size(), "the long sides of a strip carry the same hits");
  for (Index i = 0; i < a.hits.size(); ++i) {
    const HitId hit_a = a.hits.first + i;
    const HitId hit_b = b.hits.first + i;
    set_start(grid, 3 * hit_a + a.slot, face, starts_below(a, grid.hits[hit_a].reversed()));
    set_start(grid, 3 * hit_b + b.slot, face, starts_below(b, grid.hits[hit_b].reversed()));
    link(grid, 3 * hit_a + a.slot, 3 * hit_b + b.slot);
  }
}

template <typename Matcher>
void link_faces(Matcher matcher, GridData& grid) {
  std::vector<OutlineHit> outline;
  FaceMatch match;
  for_each_face(grid, cell_boxes(grid), [&](const MinimalFace& face) {
    if (face.strip()) {
      link_strip(face, grid);
      return;
    }
    collect_outline(grid, face, outline);
    matcher(face, outline, match);
    if (is_ambiguous(face)) ++grid.stats.ambiguous_faces;
    if (match.guessed) ++grid.stats.guessed_faces;
    for (const OutlineHit& h : outline) set_start(grid, h.half_edge, face, h.starts_below);
    for (Index i = 0; i < outline.size(); ++i) {
      const Index j = match.partner[i];
      if (j != kNone && j > i) link(grid, outline[i].half_edge, outline[j].half_edge);
    }
    grid.rims.insert(grid.rims.end(), match.rims.begin(), match.rims.end());
  });
}

}  // namespace

void link_half_edges(const Surface& surface, std::span<const TriangleId> triangle_of_hit,
                     Pairing pairing, GridData& grid) {
  grid.opposite.assign(3 * grid.hits.size(), kNone);
  grid.start.assign(3 * grid.hits.size(), kNone);
  if (grid.sheet) {
    link_faces(SheetMatcher(surface, triangle_of_hit, pairing, grid), grid);
  } else {
    link_faces(SolidMatcher(surface, triangle_of_hit, pairing, grid), grid);
  }
  sort_rims(grid);
}

}  // namespace kdm
