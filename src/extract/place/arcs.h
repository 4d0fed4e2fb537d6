// SPDX-License-Identifier: MIT
// Places links between two hits that lie on the same side of their minimal face.
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

/// Returns `point`, moved into the face if both hits of the link lie on the same side of the face.
/// The link is then an arc over this side, with a height of 5 % of the distance between the hits.
/// If `links` lists all links of the face, which must not cross, the height is chosen such that all
/// arcs over the side that are placed by this function keep apart, also where one lies under
/// another.
Vec3 lift_off_side(const GridView& view, const LinkFace& face, HitPair link,
                   const std::vector<HitPair>& links, Vec3 point);

}  // namespace kdm
