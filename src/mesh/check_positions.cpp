// SPDX-License-Identifier: MIT
// Checks that coordinates can be computed with.
#include "mesh/check_positions.h"

#include <cmath>

#include "kdmanifold/error.h"
#include "text/compose.h"

namespace kdm {
namespace {

// Squares of coordinates must be finite: the largest number is about 1.8e308.
constexpr double kLargestCoordinate = 1e150;

}  // namespace

void check_positions(const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3& p = mesh.positions[i];
    for (int axis = 0; axis < 3; ++axis) {
      if (!(std::abs(p[axis]) <= kLargestCoordinate)) {
        throw Error(ErrorCode::kInvalidMesh,
                    compose("positions: vertex {} has {} coordinate {}, which is not a finite "
                            "number of at most 1e150",
                            i, "xyz"[axis], p[axis]));
      }
    }
  }
}

}  // namespace kdm
