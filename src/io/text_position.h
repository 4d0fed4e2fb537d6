// SPDX-License-Identifier: MIT
// Writes positions to text.
#pragma once

#include <fmt/compile.h>

#include <iterator>
#include <string>

#include "kdmanifold/mesh_io.h"

namespace kdm {

/// Appends the coordinates of a point, rounded to 32-bit floats, and the end of the line. With
/// `Digits::kShortest` each has as few digits as tell it from all other floats, else as few as tell
/// it from all other doubles.
inline void append_position(const Vec3& p, Digits digits, std::string& text) {
  const Eigen::Vector3f single = p.cast<float>();
  const auto append = [&](const auto& v) {
    fmt::format_to(std::back_inserter(text), FMT_COMPILE("{} {} {}\n"), v[0], v[1], v[2]);
  };
  if (digits == Digits::kShortest) {
    append(single);
  } else {
    append(Vec3(single.cast<double>()));
  }
}

}  // namespace kdm
