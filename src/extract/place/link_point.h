// SPDX-License-Identifier: MIT
// Where an edge of the mesh may pass through the minimal face of its link.
#pragma once

#include <optional>
#include <span>

#include "extract/dual/dual_mesh.h"
#include "extract/dual/grid_view.h"

namespace kdm {

/// The overlap of two leaves' sides.
struct LinkFace {
  Vec3 lo;
  Vec3 hi;
  int axis;  ///< normal to it: lo and hi agree there
};

/// The face between two leaves that touch, unless it is a strip.
std::optional<LinkFace> face_between(const LatticeBox& first, const LatticeBox& second);

/// The point of the face nearest to this one that keeps off its sides, by a part of its size or by
/// the margin, if that is less.
Vec3 off_sides(const LinkFace& face, const Vec3& point, double margin);

/// Is the point, which lies in the face's plane, clear of its sides?
bool within(const LinkFace& face, const Vec3& point);

/// A link by its two hits.
struct HitPair {
  Index hit;
  Index other;
};

/// The middle between the two hits; off their line, into the face, if that is one of its sides, so
/// that arcs over one edge stay apart, nested ones nested. Given all links of the face, which do
/// not cross: so that it keeps clear of them all if they have theirs by the same rule.
Vec3 chord_point(const GridView& view, const LinkFace& face, HitPair link,
                 const std::vector<HitPair>& links = {});

/// The point, but drawn back to the plane of one of `hits` that cuts it off from the link's two by
/// more than `distance`: there is a third face between them which none of the face's sides meets.
Vec3 behind_planes(const GridView& view, HitPair link, std::span<const Index> hits, double distance,
                   const Vec3& crease);

/// Where the two hits' planes meet in the face, behind the planes of `hits`, near the middle
/// between the two where they agree. Off their line like `chord_point`.
Vec3 crease_point(const GridView& view, const LinkFace& face, HitPair link,
                  std::span<const Index> hits, double distance);

}  // namespace kdm
