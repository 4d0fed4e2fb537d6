// SPDX-License-Identifier: MIT
// Saved grids that are well-formed, of all kinds, to be damaged.
#pragma once

#include <cstdint>
#include <vector>

namespace kdm::fuzz {

using Bytes = std::vector<std::uint8_t>;

/// As `load_bytes` (targets.h) takes them.
std::vector<Bytes> grid_seeds();

}  // namespace kdm::fuzz
