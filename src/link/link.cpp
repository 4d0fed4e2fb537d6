// SPDX-License-Identifier: MIT
// Pairing half-edges across minimal faces (paper 2.1).
//
// Two hits are linked. With more, several pairings are manifold in the sense of half-edges; which
// one is right is geometry. Every pairing made here joins half-edges that run against each other,
// without crossings. On a solid's outline entering and leaving hits alternate; that is not needed,
// as long as there are as many of both.
#include "link/link.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "kdmanifold/error.h"
#include "link/link_sheet.h"
#include "link/matching.h"
#include "link/outline.h"
#include "link/rim_hits.h"
#include "prepare/rim.h"

namespace kdm {
namespace {

// The dynamic programme is cubic; beyond this many hits neighbours are paired (paper's rule).
constexpr Index kMatchingLimit = 256;

class Linking {
 public:
  Linking(const Surface& surface, std::span<const TriangleId> triangle_of_hit, Pairing pairing,
          GridData& grid)
      : surface_(surface), triangle_of_hit_(triangle_of_hit), pairing_(pairing), grid_(grid) {}

  void operator()(const MinimalFace& face) {
    if (face.strip()) {
      link_strip(face, grid_);
      return;
    }
    collect_outline(grid_, face, outline_);
    const auto count = static_cast<Index>(outline_.size());
    const auto one_way = static_cast<Index>(std::count_if(
        outline_.begin(), outline_.end(), [](const OutlineHit& h) { return h.starts_below; }));
    // Checked in release builds too: nothing sound can follow.
    if (2 * one_way != count) {
      throw Error(ErrorCode::kInternal, "hits round a minimal face have no partners");
    }
    if (pairing_ == Pairing::kTrace &&
        (surface_.repair || (count > 2 && count <= kMatchingLimit))) {
      trace_outline(surface_, triangle_of_hit_, face, outline_, traces_);
    }
    if (count == 2) {
      link(face, outline_[0], outline_[1], grid_);
      if (surface_.repair) keep_rims(face, {1, 0});
      return;
    }
    ++grid_.stats.ambiguous_faces;
    const std::vector<Index> partner = pair(face, count);
    for (Index i = 0; i < count; ++i) {
      if (partner[i] > i) link(face, outline_[i], outline_[partner[i]], grid_);
    }
    if (surface_.repair) keep_rims(face, partner);
  }

 private:
  std::vector<Index> pair(const MinimalFace& face, Index count) {
    if (pairing_ == Pairing::kInside || pairing_ == Pairing::kOutside || count > kMatchingLimit) {
      grid_.stats.guessed_faces += pairing_ == Pairing::kTrace ? 1 : 0;
      return pair_neighbours(pairing_ != Pairing::kOutside);
    }
    std::vector<Index> traced(count, kNone);
    if (pairing_ == Pairing::kTrace) {
      for (Index i = 0; i < count; ++i) traced[i] = traces_[i].end;
    }
    find_tangents(grid_, face, outline_, tangents_);
    // Traced pairs cost nothing; to part one costs more than any deviation.
    constexpr double kParting = 1e30;
    const std::vector<Index> partner = match_without_crossings(count, [&](Index i, Index j) {
      if (!compatible(outline_[i], outline_[j])) return std::numeric_limits<double>::infinity();
      if (traced[i] == j) return 0.0;
      if (traced[i] != kNone || traced[j] != kNone) return kParting;
      return deviation(tangents_[i], tangents_[j]);
    });
    if (pairing_ == Pairing::kTrace && partner != traced) ++grid_.stats.guessed_faces;
    return partner;
  }

  // Where the surface ends within the face, unless it goes on with the partner's.
  void keep_rims(const MinimalFace& face, const std::vector<Index>& partner) {
    if (pairing_ != Pairing::kTrace) return;
    for (Index i = 0; i < partner.size(); ++i) {
      if (traces_[i].rim == kNone) continue;
      const RimHit rim = rim_hit(surface_, face, outline_[i].half_edge, traces_[i].rim);
      const Index other = traces_[partner[i]].rim;
      if (other != kNone && is_seam(rim.point, rim_point(surface_, other, face.axis, face.plane))) {
        continue;
      }
      grid_.rims.push_back(rim);
    }
  }

  // Paper 2.1: links consecutive hits, those at the ends of inside (or outside) stretches.
  std::vector<Index> pair_neighbours(bool inside) const {
    std::vector<bool> opens;
    for (const OutlineHit& h : outline_) {
      // The outline enters the solid at an ascending hit that does not lead out, and the like.
      const bool enters = grid_.hits[h.hit].leaving() != h.ascending;
      opens.push_back(enters == inside);
    }
    return match_brackets(opens);
  }

  const Surface& surface_;
  std::span<const TriangleId> triangle_of_hit_;
  Pairing pairing_;
  GridData& grid_;
  std::vector<OutlineHit> outline_;
  std::vector<Traced> traces_;
  std::vector<Tangent> tangents_;
};

}  // namespace

void link_half_edges(const Surface& surface, std::span<const TriangleId> triangle_of_hit,
                     Pairing pairing, GridData& grid) {
  grid.opposite.assign(3 * grid.hits.size(), kNone);
  grid.start.assign(3 * grid.hits.size(), kNone);
  if (grid.sheet) {
    link_sheet(surface, triangle_of_hit, pairing, grid);
    return;
  }
  Linking linking(surface, triangle_of_hit, pairing, grid);
  for_each_face(grid, cell_boxes(grid), linking);
  sort_rims(grid);
}

}  // namespace kdm
