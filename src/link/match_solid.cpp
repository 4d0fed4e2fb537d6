// SPDX-License-Identifier: MIT
// Pairs the hits round a minimal face of a solid.
#include <algorithm>
#include <limits>

#include "kdmanifold/error.h"
#include "link/match_face.h"
#include "link/matching.h"
#include "link/rim_hits.h"
#include "prepare/rim.h"

namespace kdm {
namespace {

// The dynamic programme is cubic: 3 million steps with so many hits. With more, neighbours are
// paired, which is the rule of the paper.
constexpr Index kMatchingLimit = 256;

// As many half-edges must lead up across a face as down. Checked in release builds too: nothing
// sound can follow.
void check_directions(const std::vector<OutlineHit>& outline) {
  const auto upwards = static_cast<std::size_t>(std::count_if(
      outline.begin(), outline.end(), [](const OutlineHit& h) { return h.starts_below; }));
  if (2 * upwards != outline.size()) {
    throw Error(ErrorCode::kInternal, "hits round a minimal face have no partners");
  }
}

}  // namespace

void SolidMatcher::operator()(const MinimalFace& face, const std::vector<OutlineHit>& outline,
                              FaceMatch& match) {
  check_directions(outline);
  const bool several = outline.size() > 2;
  match.guessed = false;
  match.rims.clear();
  if (pairing_ == Pairing::kTrace &&
      (surface_.repair || (several && outline.size() <= kMatchingLimit))) {
    trace_outline(surface_, triangle_of_hit_, face, outline, traces_);
  }
  if (several) {
    pair_hits(face, outline, match);
  } else {
    match.partner.assign({1, 0});
  }
  if (surface_.repair && pairing_ == Pairing::kTrace) keep_rims(face, outline, match);
}

void SolidMatcher::pair_hits(const MinimalFace& face, const std::vector<OutlineHit>& outline,
                             FaceMatch& match) {
  const auto count = static_cast<Index>(outline.size());
  if (pairing_ == Pairing::kInside || pairing_ == Pairing::kOutside || count > kMatchingLimit) {
    match.guessed = pairing_ == Pairing::kTrace;
    match.partner = pair_neighbours(outline, pairing_ != Pairing::kOutside);
    return;
  }
  std::vector<Index> traced(count, kNone);
  if (pairing_ == Pairing::kTrace) {
    for (Index i = 0; i < count; ++i) traced[i] = traces_[i].end;
  }
  find_tangents(grid_, face, outline, tangents_);
  // A traced pair costs nothing. To part one costs more than any deviation, which is a few squared
  // extents of the lattice at most, about 1e13.
  constexpr double kParting = 1e30;
  // Where traces do not decide, solids cross and what is inside touches itself, as that of a
  // symmetric difference does. It is parted there, all along the curve.
  constexpr double kContact = 1e15;
  const bool part = surface_.several_solids() && pairing_ == Pairing::kTrace;
  match.partner = match_without_crossings(count, [&](Index i, Index j) {
    if (!compatible(outline[i], outline[j])) return std::numeric_limits<double>::infinity();
    if (traced[i] == j) return 0.0;
    if (traced[i] != kNone || traced[j] != kNone) return kParting;
    const double off = deviation(tangents_[i], tangents_[j]);
    return part ? kContact * stretch_inside(outline, i, j) + off : off;
  });
  match.guessed = pairing_ == Pairing::kTrace && match.partner != traced;
}

// Tells whether the outline, followed in cyclic order, enters the solid at the hit. Where it runs
// up the grid edge it does so at hits that are not leaving; where it runs down, at hits that are.
bool SolidMatcher::enters(const OutlineHit& h) const {
  return grid_.hits[h.hit].leaving() != h.ascending;
}

// Of two hits of which the outline enters the solid at one and leaves it at the other, returns how
// many hits it is from the one to the other. The sum over all pairs is least where consecutive
// hits, the ends of stretches inside the solid, are paired.
Index SolidMatcher::stretch_inside(const std::vector<OutlineHit>& outline, Index i, Index j) const {
  const auto count = static_cast<Index>(outline.size());
  return enters(outline[i]) ? (j + count - i) % count : (i + count - j) % count;
}

// Pairs consecutive hits, the ends of stretches of the outline inside the solid, or outside of it.
std::vector<Index> SolidMatcher::pair_neighbours(const std::vector<OutlineHit>& outline,
                                                 bool inside) const {
  std::vector<bool> opens;
  for (const OutlineHit& h : outline) opens.push_back(enters(h) == inside);
  return match_brackets(opens);
}

// Keeps the point where the surface ends within the face, unless the partner's section ends there
// too: then the surface goes on, but for a crack.
void SolidMatcher::keep_rims(const MinimalFace& face, const std::vector<OutlineHit>& outline,
                             FaceMatch& match) {
  for (Index i = 0; i < outline.size(); ++i) {
    if (traces_[i].rim == kNone) continue;
    const RimHit rim = rim_hit(surface_, face, outline[i].half_edge, traces_[i].rim);
    const SideId other = traces_[match.partner[i]].rim;
    if (other != kNone && is_seam(rim.point, rim_point(surface_, other, face.axis, face.plane))) {
      continue;
    }
    match.rims.push_back(rim);
  }
}

}  // namespace kdm
