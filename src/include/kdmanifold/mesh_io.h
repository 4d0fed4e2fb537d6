// SPDX-License-Identifier: MIT
// Reading and writing OBJ, STL, PLY and OFF.
#pragma once

#include <string>
#include <string_view>

#include "kdmanifold/mesh.h"

namespace kdm {

enum class MeshFormat { kObj, kStl, kPly, kOff };

/// The format that a file name's extension stands for (any case). Throws `kIoError` for others.
MeshFormat format_from_path(std::string_view path);

/// Reads a mesh from a file. Polygons are cut into triangles, concave ones properly; only
/// geometry is read (no materials, no colours, groups are ignored). STL facets come as three
/// vertices each. Throws `kIoError` if the file cannot be read and `kParseError`, with the line
/// or byte, if its content is malformed.
Mesh read_mesh(const std::string& path);

/// The same from memory; `name` is what error messages call the source.
Mesh parse_mesh(std::string_view bytes, MeshFormat format, std::string_view name = "input");

/// Writes a mesh; the extension decides the format (STL and PLY binary). Positions are written
/// so that reading them back as 32-bit floats gives the 32-bit value of each coordinate.
/// The file appears complete or not at all. Throws `kIoError`.
void write_mesh(const std::string& path, const Mesh& mesh);

/// The same into memory.
std::string format_mesh(const Mesh& mesh, MeshFormat format);

}  // namespace kdm
