// SPDX-License-Identifier: MIT
// Saves and loads grids, so that one is built once and extracted from many times.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kdmanifold/grid.h"

namespace kdm {

/// Saves the grid with its hits, planes, links, rims, corners and reports, in a format of this
/// library's own (described in src/grid/saved/grid_format.h): 17 to 27 bytes a hit, up to 35 for
/// sheets with much rim; less than half of the grid's memory. The same grid gives the same bytes on
/// every platform. The time grows linearly with the grid. Throws `kOutOfMemory`.
std::vector<std::uint8_t> save_grid(const Grid& grid);

/// Loads a saved grid. What is extracted from it is the same to the last bit, and saving it again
/// gives the same bytes. Time and memory grow linearly with the bytes. Everything is checked: bytes
/// that are cut off, damaged or made up give `kParseError`, with the byte or the broken rule, as
/// does a version that this library does not know; `name` is what messages call the source. Throws
/// `kOutOfMemory`.
Grid load_grid(std::span<const std::uint8_t> bytes, std::string_view name = "grid");

/// Says whether the file's name ends in `.kdgrid` (any case), as the names of saved grids do.
bool names_a_grid(std::string_view path);

/// Saves the grid into a file, which appears complete or not at all. Throws `kIoError`, also if its
/// name does not end in `.kdgrid`, and `kOutOfMemory`.
void write_grid(const std::string& path, const Grid& grid);

/// Loads a grid from a file. Throws `kIoError` if it cannot be read, else as `load_grid` does.
Grid read_grid(const std::string& path);

}  // namespace kdm
