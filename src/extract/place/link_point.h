// SPDX-License-Identifier: MIT
// Finds points at which an edge of the mesh may pass through the minimal face of its link.
#pragma once

#include <span>
#include <vector>

#include "extract/dual/grid_view.h"
#include "extract/place/arcs.h"
#include "extract/place/link_face.h"

namespace kdm {

/// Returns the middle between the two hits of the link, moved into the face where both lie on one
/// of its sides; see `lift_off_side`, also for `links`.
Vec3 chord_point(const GridView& view, const LinkFace& face, HitPair link,
                 const std::vector<HitPair>& links = {});

/// Returns `crease`, unless the plane of one of `hits` cuts it off from both hits of the link by
/// more than `distance` (lattice units). If so, returns the point where this plane cuts the segment
/// from `crease` to the middle between the two hits: a third face of the input lies between the two
/// hits and meets none of the minimal face's sides. Of several such planes, the one that cuts off
/// most is used.
Vec3 behind_planes(const GridView& view, HitPair link, std::span<const HitId> hits, double distance,
                   const Vec3& crease);

/// Returns the point of the face where the planes of the link's two hits meet, nearest to the
/// middle between the hits, moved by `behind_planes` and, where both hits lie on one side of the
/// face, by `lift_off_side`. Where the planes meet far beyond the hits and make no sharp edge,
/// starts from the middle instead of this point.
Vec3 crease_point(const GridView& view, const LinkFace& face, HitPair link,
                  std::span<const HitId> hits, double distance);

}  // namespace kdm
