// SPDX-License-Identifier: MIT
// What the fuzzers do with bytes; libFuzzer and the fixed-seed smoke run share it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace kdm::fuzz {

/// The first byte picks a format, the rest is the file. A parser either throws `kParseError` or
/// gives a sound mesh that survives being written and read again. Aborts otherwise.
void parse_bytes(const std::uint8_t* bytes, std::size_t size);

/// The first four bytes are options, the rest is a closed mesh (see `shapes::mesh_from_bytes`), or
/// as a sheet what is left of it where faces are missing or turned over. The grid must be valid and
/// the surface 2-manifold, a sheet's with boundary. Aborts otherwise.
void build_from_bytes(const std::uint8_t* bytes, std::size_t size);

/// The bytes are a saved grid without its header, whose checksum nobody guesses. They either give
/// `kParseError` or a valid grid that survives being saved again and whose surface is 2-manifold, a
/// sheet's with boundary. Aborts otherwise.
void load_bytes(const std::uint8_t* bytes, std::size_t size);

}  // namespace kdm::fuzz
