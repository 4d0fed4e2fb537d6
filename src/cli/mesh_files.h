// SPDX-License-Identifier: MIT
// Meshes and grids, from files and to files.
#pragma once

#include <string>
#include <vector>

#include "cli/file_format.h"
#include "kdmanifold/kdmanifold.h"

namespace kdm::cli {

/// A mesh that was read, and what was skipped, left out or assumed.
struct ReadMesh {
  Mesh mesh;
  std::vector<Warning> warnings;
};

/// Reads an input. Throws `Error`.
ReadMesh read_mesh_file(const std::string& path, FileFormat format);
/// Loads a saved grid. Throws `Error`.
Grid read_grid_file(const std::string& path);

/// Returns the bytes of the file. Throws `Error`.
std::string format_file(const Mesh& mesh, FileFormat format, Digits digits);

/// Writes the grid into a file. Throws `Error`.
void write_grid_file(const std::string& path, const Grid& grid);

}  // namespace kdm::cli
