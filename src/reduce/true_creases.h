// SPDX-License-Identifier: MIT
// Where the reference has creases.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "reduce/reference.h"

namespace kdm {

/// Finds edges at which two triangles of the reference turn by more than 15 degrees against each
/// other. What it has found out about a side it remembers.
class TrueCreases {
 public:
  /// A point is near to a crease within `reach`. The reference must outlive this.
  TrueCreases(const Reference& reference, double reach)
      : reference_(reference), reach_(reach), sides_(3 * std::size_t{reference.size()}) {}

  bool are_near(const Vec3& p);

 private:
  enum class Side : std::uint8_t { kUnknown, kSmooth, kCrease };

  bool is_crease(TriangleId t, int corner);
  bool find_out(TriangleId t, int corner) const;

  const Reference& reference_;
  double reach_;
  std::vector<Side> sides_;  // three a triangle
};

}  // namespace kdm
