// SPDX-License-Identifier: MIT
// The surface that a reduced mesh must stay near to.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "geometry/triangle.h"
#include "reduce/triangle_tree.h"

namespace kdm {

/// Triangles, asked for what is near to a point.
class Reference {
 public:
  explicit Reference(std::vector<std::array<Vec3, 3>> triangles);

  Index size() const { return static_cast<Index>(triangles_.size()); }
  const std::array<Vec3, 3>& corners(TriangleId t) const { return triangles_[t]; }

  /// Tells whether a triangle is within `distance` of the point. Looks at the triangle `hint` first
  /// (kNone: at none) and sets it to the one that was found.
  bool is_near(const Vec3& p, double distance, TriangleId& hint) const;
  /// Returns the nearest triangle of those within `distance`, or kNone; the first that is found
  /// within `enough` will do. Begins at the triangle `hint` (kNone: anywhere); of several that are
  /// equally near, any may be returned.
  TriangleId nearest(const Vec3& p, double distance, TriangleId hint, double enough = 0) const;
  /// Returns the nearest triangle of those for which `counts(t)` is true, or kNone.
  template <typename Counts>
  TriangleId nearest_of(const Vec3& p, TriangleId hint, const Counts& counts) const {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    return tree_.nearest(p, std::numeric_limits<double>::max(), 0, hint,
                         [&](TriangleId t) { return counts(t) ? squared_distance(t, p) : kFar; });
  }
  /// The same of those only whose normals point to the same side as `normal`.
  template <typename Counts>
  TriangleId nearest_facing(const Vec3& p, const Vec3& normal, TriangleId hint,
                            const Counts& counts) const {
    return nearest_of(p, hint, [&](TriangleId t) {
      const std::array<Vec3, 3>& c = triangles_[t];
      return counts(t) && unit_normal(c[0], c[1], c[2]).dot(normal) > 0;
    });
  }
  double squared_distance(TriangleId t, const Vec3& p) const;
  const TriangleTree& tree() const { return tree_; }

 private:
  std::vector<std::array<Vec3, 3>> triangles_;
  TriangleTree tree_;
};

}  // namespace kdm
