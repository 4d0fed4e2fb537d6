// SPDX-License-Identifier: MIT
// Links between hits that lie on one side of their minimal face.
#pragma once

#include <vector>

#include "extract/dual/grid_view.h"
#include "extract/place/link_face.h"

namespace kdm {

/// A link, named by the two hits that it joins.
struct HitPair {
  HitId hit;
  HitId other;
};

/// Returns `point`, moved into the face if both hits of the link lie on one side of the face: the
/// link then is an arc over that side, which leaves it by 5 % of the distance between the hits.
/// Given all `links` of the face, which do not cross, the arc's height is such that arcs over one
/// side stay apart and nested ones nested, if each of them is placed by this rule.
Vec3 lift_off_side(const GridView& view, const LinkFace& face, HitPair link,
                   const std::vector<HitPair>& links, Vec3 point);

}  // namespace kdm
