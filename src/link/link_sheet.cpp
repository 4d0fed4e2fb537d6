// SPDX-License-Identifier: MIT
// Links of sheets.
//
// The section of the surface with a minimal face runs from hit to hit or from a hit to the rim.
// The first two are linked, the last stays on the boundary, and the point where the rim passes
// through the face is kept: the vertices at both ends of the boundary edge belong on the rim.
// Nothing alternates round a sheet's face, so two hits may be linked iff their half-edges run
// against each other. Traced links cross where the input crosses itself.
// What no trace decides (there is none with the other pairings) is matched at least deviation,
// as many as possible. So are rims that lie within rounding of each other: cracks of the input.
#include "link/link_sheet.h"

#include "link/matching.h"
#include "link/outline.h"
#include "link/rim_hits.h"
#include "prepare/rim.h"

namespace kdm {
namespace {

class SheetLinking {
 public:
  SheetLinking(const Surface& surface, std::span<const TriangleId> triangle_of_hit, Pairing pairing,
               GridData& grid)
      : surface_(surface), triangle_of_hit_(triangle_of_hit), pairing_(pairing), grid_(grid) {}

  void operator()(const MinimalFace& face) {
    if (face.strip()) {
      link_strip(face, grid_);
      return;
    }
    collect_outline(grid_, face, outline_);
    for (const OutlineHit& h : outline_) {
      grid_.start[h.half_edge] = h.starts_below ? face.below : face.above;
    }
    const auto count = static_cast<Index>(outline_.size());
    if (count > 2) ++grid_.stats.ambiguous_faces;
    rims_.assign(count, {kNone, Vec3::Zero(), Vec3::Zero()});
    partner_.assign(count, kNone);
    if (pairing_ == Pairing::kTrace) trace_all(face);
    match_rest(face);
    for (Index i = 0; i < count; ++i) {
      if (partner_[i] != kNone) {
        grid_.opposite[outline_[i].half_edge] = outline_[partner_[i]].half_edge;
      } else if (rims_[i].half_edge != kNone) {
        grid_.rims.push_back(rims_[i]);
      }
    }
  }

 private:
  // Keeps what is traced, and where the surface ends within the face.
  void trace_all(const MinimalFace& face) {
    trace_outline(surface_, triangle_of_hit_, face, outline_, traces_);
    for (Index i = 0; i < traces_.size(); ++i) {
      partner_[i] = traces_[i].end;
      if (traces_[i].rim != kNone) {
        rims_[i] = rim_hit(surface_, face, outline_[i].half_edge, traces_[i].rim);
      }
    }
  }

  void match_rest(const MinimalFace& face) {
    open_.clear();
    for (Index i = 0; i < partner_.size(); ++i) {
      if (partner_[i] == kNone) open_.push_back(i);
    }
    if (open_.size() < 2) return;
    find_tangents(grid_, face, outline_, tangents_);
    const std::vector<Index> matched = match_some(
        static_cast<Index>(open_.size()),
        [&](Index i, Index j) { return may_pair(open_[i], open_[j]); },
        [&](Index i, Index j) { return deviation(tangents_[open_[i]], tangents_[open_[j]]); });
    bool guessed = false;
    for (Index i = 0; i < matched.size(); ++i) {
      if (matched[i] == kNone) continue;
      guessed = guessed || rims_[open_[i]].half_edge == kNone;
      partner_[open_[i]] = open_[matched[i]];
    }
    if (guessed && pairing_ == Pairing::kTrace) ++grid_.stats.guessed_faces;
  }

  bool may_pair(Index i, Index j) const {
    if (!compatible(outline_[i], outline_[j])) return false;
    const bool ends = rims_[i].half_edge != kNone;
    if (ends != (rims_[j].half_edge != kNone)) return false;
    return !ends || is_seam(rims_[i].point, rims_[j].point);
  }

  const Surface& surface_;
  std::span<const TriangleId> triangle_of_hit_;
  Pairing pairing_;
  GridData& grid_;
  std::vector<OutlineHit> outline_;
  std::vector<Traced> traces_;
  std::vector<Index> partner_;
  std::vector<RimHit> rims_;  // per hit of the outline; its half-edge is kNone if there is none
  std::vector<Index> open_;   // those of the outline without partner
  std::vector<Tangent> tangents_;
};

}  // namespace

void link_sheet(const Surface& surface, std::span<const TriangleId> triangle_of_hit,
                Pairing pairing, GridData& grid) {
  SheetLinking linking(surface, triangle_of_hit, pairing, grid);
  for_each_face(grid, cell_boxes(grid), linking);
  sort_rims(grid);
}

}  // namespace kdm
