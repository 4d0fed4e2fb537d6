// SPDX-License-Identifier: MIT
// Real numbers of a saved grid, held against what they may be.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "io/bytes.h"
#include "kdmanifold/types.h"

namespace kdm {

/// The next number. Throws unless it is within the bounds: what is not finite fails.
inline double take_real(ByteReader& bytes, double least, double most, std::string_view what) {
  bytes.require(1, sizeof(double), what);
  const std::size_t at = bytes.offset();
  const double value = bytes.take<double, std::uint64_t>();
  if (!(value >= least && value <= most)) {
    bytes.fail_at(at,
                  fmt::format("{} is {}; it should be from {} to {}", what, value, least, most));
  }
  return value;
}

/// The next three numbers. Throws unless they are a vector of length 1, or 0 if that is allowed.
inline Vec3 take_normal(ByteReader& bytes, bool may_be_zero, std::string_view what) {
  Vec3 normal;
  const std::size_t at = bytes.offset();
  for (int axis = 0; axis < 3; ++axis) normal[axis] = take_real(bytes, -1.1, 1.1, what);
  constexpr double kRounding = 1e-6;
  const double square = normal.squaredNorm();
  if (std::abs(square - 1) > kRounding && !(may_be_zero && square == 0)) {
    bytes.fail_at(at, fmt::format("{} is not of length 1", what));
  }
  return normal;
}

}  // namespace kdm
