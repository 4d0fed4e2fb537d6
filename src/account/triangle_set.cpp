// SPDX-License-Identifier: MIT
// Searches the tree over the triangles.
#include "account/triangle_set.h"

#include <limits>

#include "mesh/boxes.h"

namespace kdm {

const BoxTree& TriangleSet::tree() {
  if (!tree_) {
    boxes_.reserve(triangles.size());
    for (Index t = 0; t < size(); ++t) {
      boxes_.push_back(box_of(corner(t, 0), corner(t, 1), corner(t, 2)));
    }
    tree_ = std::make_unique<BoxTree>(boxes_);
  }
  return *tree_;
}

double TriangleSet::squared_distance(const Vec3& point, double enough, Index guess) {
  if (triangles.empty()) return std::numeric_limits<double>::infinity();
  double nearest = squared_distance_of(last_, point);
  if (nearest <= enough) return nearest;
  if (guess != kNone && guess != last_) {
    const double squared = squared_distance_of(guess, point);
    if (squared < nearest) {
      nearest = squared;
      last_ = guess;
      if (nearest <= enough) return nearest;
    }
  }
  return tree().least(point, nearest, enough, [&](Index t) {
    const double squared = squared_distance_of(t, point);
    if (squared < nearest) {
      nearest = squared;
      last_ = t;
    }
    return squared;
  });
}

int TriangleSet::winding(const Vec3& point) {
  if (!sight_) sight_ = std::make_unique<Sight>(triangles, positions, Marks(triangles.size()));
  // Whatever is aligned with anything has another direction.
  return sight_->winding(point, Vec3(0.5411961, 0.6302905, 0.5566704), kNone);
}

}  // namespace kdm
