// SPDX-License-Identifier: MIT
#include "split/planned_hits.h"

#include <algorithm>

namespace kdm {

void PlannedHits::plan(const Surface& surface, const LatticeBox& box,
                       const CellCrossings& crossings) {
  hits_.clear();
  for (const CellCrossing& crossing : crossings.all) {
    if (!crossing.kept) continue;
    hits_.push_back({crossing_point(crossing, box), &surface.planes[crossing.triangle],
                     crossing.triangle, kNone});
  }
}

void PlannedHits::assign_pieces(const CellSurface& cell) {
  for (PlannedHit& hit : hits_) hit.piece = cell.piece_of_triangle(hit.triangle);
}

bool PlannedHits::meets_another_plane(const Vec3& point, PieceId piece, double distance) {
  for (std::size_t i = 0; i < hits_.size(); ++i) {
    if (!meets(i, point, piece, distance)) continue;
    last_plane_met_ = i;
    return true;
  }
  return false;
}

bool PlannedHits::triangle_meets_a_plane(const LatticeTriangle& t, PieceId piece, double distance) {
  const auto meets_all = [&](std::size_t i) {
    return is_of(hits_[i], piece) && std::all_of(t.begin(), t.end(), [&](const LatticePoint& p) {
             return hits_[i].plane->distance(to_vec3(p)) <= distance;
           });
  };
  if (last_plane_met_ < hits_.size() && meets_all(last_plane_met_)) return true;
  for (std::size_t i = 0; i < hits_.size(); ++i) {
    if (!meets_all(i)) continue;
    last_plane_met_ = i;
    return true;
  }
  return false;
}

}  // namespace kdm
