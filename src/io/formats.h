// SPDX-License-Identifier: MIT
// The readers and writers of the file formats. They work in memory and touch no files.
//
// How a file becomes a mesh:
// - read_mesh (mesh_files.cpp) finds the format by the file's name, reads the whole file
//   (files.h), and hands its bytes to parse_mesh (mesh_io.cpp).
// - parse_mesh makes UTF-8 of UTF-16 (decode_text.h), asks the content what it is (sniff.h), and
//   picks the reader below: by the content if that is certain, else by the format asked for.
// - A reader takes the bytes apart: text with TextScanner (text_scanner.h), binary data with
//   ByteReader (bytes.h). Both know how far they are, so that every error names a line or a byte.
//   A PLY file has a header that says which of the two follows (ply_header.h).
// - It gives vertices and faces, in the order of the file, to MeshBuilder (mesh_builder.h), which
//   makes a triangle mesh of them: faces with more corners are cut by Triangulator (triangulate.h).
//   `source_faces` keeps the number of each triangle's face in the file.
// - No reader welds vertices or drops faces with an area: a mesh is what its file says. Faces that
//   have none, or no finite one, are skipped with a warning (warnings.h).
//
// How a mesh becomes a file: format_mesh (mesh_io.cpp) checks that the mesh can be written, and
// the writer below makes the file's bytes (bytes.h; text_line.h for lines of numbers).
// write_mesh (mesh_files.cpp) puts them into a file.
#pragma once

#include <string>
#include <string_view>

#include "io/warnings.h"
#include "kdmanifold/mesh.h"
#include "kdmanifold/mesh_io.h"

namespace kdm {

/// The size in bytes from which files are refused. Every vertex, corner and face takes a byte at
/// least; so whatever is in a smaller file can be counted in an Index.
inline constexpr std::uint64_t kLargestFile = 0xffffffffu;

/// Read a mesh. `name` is what messages call the file; `warnings` gets what is skipped or assumed.
/// Throw `kParseError` with the line or byte at fault.
Mesh parse_obj(std::string_view text, std::string_view name, Warnings& warnings);
Mesh parse_stl(std::string_view bytes, std::string_view name, Warnings& warnings);
Mesh parse_ply(std::string_view bytes, std::string_view name, Warnings& warnings);
Mesh parse_off(std::string_view text, std::string_view name, Warnings& warnings);

/// Return the bytes of a file. All vertices that faces name must exist, and coordinates must be
/// finite as 32-bit floats: `format_mesh` checks that.
std::string format_obj(const Mesh& mesh, Digits digits);
std::string format_stl(const Mesh& mesh);
std::string format_ply(const Mesh& mesh);
std::string format_off(const Mesh& mesh, Digits digits);

}  // namespace kdm
