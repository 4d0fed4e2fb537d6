// SPDX-License-Identifier: MIT
// The arrays of a GLB file.
#pragma once

#include <cstdint>
#include <vector>

#include "cli/glb/container.h"
#include "kdmanifold/types.h"

namespace kdm::cli::glb {

/// Read what accessor `index` holds: points of floats or (normalised) integers, or vertex numbers
/// of unsigned integers; interleaved or not, sparse or not. `user` refers to it. Throw
/// `kParseError` if it is malformed or its bytes are in another file.
std::vector<Vec3> read_points(const Container& file, std::uint64_t index, const std::string& user);
std::vector<Index> read_numbers(const Container& file, std::uint64_t index,
                                const std::string& user);

}  // namespace kdm::cli::glb
