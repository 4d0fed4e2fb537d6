// SPDX-License-Identifier: MIT
// The readers and writers behind parse_mesh and format_mesh; they touch no files.
#pragma once

#include <string>
#include <string_view>

#include "kdmanifold/mesh.h"
#include "kdmanifold/mesh_io.h"

namespace kdm {

/// Every vertex, corner and face takes at least a byte, so whatever passes this size test can be
/// counted in an Index.
inline constexpr std::uint64_t kLargestFile = 0xffffffffu;

/// Each throws `kParseError` with the line or byte at fault.
Mesh parse_obj(std::string_view text, std::string_view name);
Mesh parse_stl(std::string_view bytes, std::string_view name);
Mesh parse_ply(std::string_view bytes, std::string_view name);
Mesh parse_off(std::string_view text, std::string_view name);

/// The mesh must have passed `check_writable`.
std::string format_obj(const Mesh& mesh, Digits digits);
std::string format_stl(const Mesh& mesh);
std::string format_ply(const Mesh& mesh);
std::string format_off(const Mesh& mesh, Digits digits);

}  // namespace kdm
