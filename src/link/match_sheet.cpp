// SPDX-License-Identifier: MIT
// Pairs the hits round a minimal face of a sheet.
#include "link/match_face.h"
#include "link/matching.h"
#include "link/rim_hits.h"
#include "prepare/rim.h"

namespace kdm {

void SheetMatcher::operator()(const MinimalFace& face, const std::vector<OutlineHit>& outline,
                              FaceMatch& match) {
  match.guessed = false;
  match.rims.clear();
  match.partner.assign(outline.size(), kNone);
  rims_.assign(outline.size(), {kNone, Vec3::Zero(), Vec3::Zero()});
  if (pairing_ == Pairing::kTrace) trace_all(face, outline, match);
  match_rest(face, outline, match);
  for (Index i = 0; i < outline.size(); ++i) {
    if (match.partner[i] == kNone && rims_[i].half_edge != kNone) match.rims.push_back(rims_[i]);
  }
}

// Pairs hits whose traces arrive at each other, and finds where the surface ends within the face.
void SheetMatcher::trace_all(const MinimalFace& face, const std::vector<OutlineHit>& outline,
                             FaceMatch& match) {
  trace_outline(surface_, triangle_of_hit_, face, outline, traces_);
  for (Index i = 0; i < traces_.size(); ++i) {
    match.partner[i] = traces_[i].end;
    if (traces_[i].rim != kNone) {
      rims_[i] = rim_hit(surface_, face, outline[i].half_edge, traces_[i].rim);
    }
  }
}

void SheetMatcher::match_rest(const MinimalFace& face, const std::vector<OutlineHit>& outline,
                              FaceMatch& match) {
  open_.clear();
  for (Index i = 0; i < match.partner.size(); ++i) {
    if (match.partner[i] == kNone) open_.push_back(i);
  }
  if (open_.size() < 2) return;
  find_tangents(grid_, face, outline, tangents_);
  const std::vector<Index> matched = match_some(
      static_cast<Index>(open_.size()),
      [&](Index i, Index j) {
        const Index a = open_[i];
        const Index b = open_[j];
        return may_pair(outline[a], outline[b], rims_[a], rims_[b]);
      },
      [&](Index i, Index j) { return deviation(tangents_[open_[i]], tangents_[open_[j]]); });
  bool guessed = false;
  for (Index i = 0; i < matched.size(); ++i) {
    if (matched[i] == kNone) continue;
    guessed = guessed || rims_[open_[i]].half_edge == kNone;
    match.partner[open_[i]] = open_[matched[i]];
  }
  match.guessed = guessed && pairing_ == Pairing::kTrace;
}

// Hits may be paired if neither one's section ends at a rim, or both do at the same place.
bool SheetMatcher::may_pair(const OutlineHit& a, const OutlineHit& b, const RimHit& rim_of_a,
                            const RimHit& rim_of_b) const {
  if (!compatible(a, b)) return false;
  const bool ends = rim_of_a.half_edge != kNone;
  if (ends != (rim_of_b.half_edge != kNone)) return false;
  return !ends || is_seam(rim_of_a.point, rim_of_b.point);
}

}  // namespace kdm
