// SPDX-License-Identifier: MIT
// A position in text, as 32-bit numbers.
#pragma once

#include <fmt/compile.h>

#include <iterator>
#include <string>

#include "kdmanifold/mesh_io.h"

namespace kdm {

/// Ends the line.
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
