// SPDX-License-Identifier: MIT
// How far each level of a reduced mesh and the reference are apart.
#pragma once

#include <vector>

#include "kdmanifold/deviation.h"
#include "kdmanifold/mesh.h"
#include "reduce/reference.h"

namespace kdm {

/// Measures levels, one after the other, in points: vertices of both surfaces, and some 4,000
/// points spread evenly over the area of either, of which the mean is taken.
class LevelErrors {
 public:
  /// Parts of the reference from which `surface` is further than `reach` do not count: whatever was
  /// to be reduced lacks them already. `reference` must outlive this.
  LevelErrors(const Reference& reference, const Reference& surface, double reach);

  /// Measures triangles over positions of about 1, as the reference has them.
  MeshError of(const Mesh& level) const;

 private:
  // A point of the reference.
  struct Point {
    Vec3 place;
    bool for_mean;
  };

  const Reference& reference_;
  std::vector<Point> points_;
};

}  // namespace kdm
