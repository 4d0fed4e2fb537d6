// SPDX-License-Identifier: MIT
// Cuts the rounds of rim sides at the points that they pass more than once.
#include "prepare/holes.h"

#include <utility>

#include "mesh/boundary_loops.h"
#include "mesh/sides.h"

namespace kdm {
namespace {

class HoleFinder {
 public:
  HoleFinder(std::span<const Triangle> triangles, Index points)
      : triangles_(triangles), place_of_(points, kNone) {}

  void add_round(const std::vector<SideId>& round) {
    for (const SideId side : round) {
      const PointId from = start_of(side);
      if (place_of_[from] != kNone) cut_off(place_of_[from]);
      place_of_[from] = static_cast<Index>(path_.size());
      path_.push_back(side);
    }
    cut_off(0);
  }

  std::vector<Hole> take_holes() { return std::move(holes_); }

 private:
  PointId start_of(SideId side) const { return triangles_[triangle_of(side)][corner_of(side)]; }

  // Takes the sides from this place on off the path: they lead back to where the first one starts.
  void cut_off(Index first) {
    for (std::size_t i = first; i < path_.size(); ++i) place_of_[start_of(path_[i])] = kNone;
    if (path_.size() - first > 2) {
      holes_.push_back({{path_.begin() + first, path_.end()}});
    }
    path_.resize(first);
  }

  std::span<const Triangle> triangles_;
  std::vector<Index> place_of_;  // per point: the place on the path of the side that starts there
  std::vector<SideId> path_;
  std::vector<Hole> holes_;
};

}  // namespace

std::vector<Hole> find_holes(std::span<const Triangle> triangles, Index points,
                             std::span<const SideId> opposite) {
  HoleFinder finder(triangles, points);
  for (const BoundaryLoop& round : find_rim_loops(opposite)) finder.add_round(round.vertices);
  return finder.take_holes();
}

}  // namespace kdm
