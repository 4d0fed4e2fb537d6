// SPDX-License-Identifier: MIT
// An oriented plane.
#pragma once

#include "kdmanifold/types.h"

namespace kdm {

/// A plane in unrounded lattice coordinates: normal . x = offset, |normal| = 1.
struct Plane {
  Vec3 normal = Vec3::Zero();
  double offset = 0;
};

}  // namespace kdm
