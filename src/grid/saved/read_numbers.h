// SPDX-License-Identifier: MIT
// Reads real numbers of a saved grid and checks each against its range.
#pragma once

#include <cmath>
#include <string_view>

#include "io/bytes.h"
#include "kdmanifold/types.h"
#include "text/compose.h"

namespace kdm {

/// Reads the next number, which error messages call `what`. Throws unless it lies in [least, most];
/// a number that is not finite does not.
inline double take_real(ByteReader& bytes, double least, double most, std::string_view what) {
  bytes.require(1, sizeof(double), what);
  const std::size_t at = bytes.offset();
  const double value = bytes.take<double, std::uint64_t>();
  if (!(value >= least && value <= most)) {
    bytes.fail_at(at, compose("{} is {}; it should be from {} to {}", what, value, least, most));
  }
  return value;
}

/// Reads the next three numbers, which error messages call `what`. Throws unless they form a vector
/// of length 1, up to rounding, or of length 0 if it `may_be_zero`.
inline Vec3 take_normal(ByteReader& bytes, bool may_be_zero, std::string_view what) {
  Vec3 normal;
  const std::size_t at = bytes.offset();
  for (int axis = 0; axis < 3; ++axis) normal[axis] = take_real(bytes, -1.1, 1.1, what);
  constexpr double kRounding = 1e-6;
  const double square = normal.squaredNorm();
  if (std::abs(square - 1) > kRounding && !(may_be_zero && square == 0)) {
    bytes.fail_at(at, compose("{} is not of length 1", what));
  }
  return normal;
}

}  // namespace kdm
