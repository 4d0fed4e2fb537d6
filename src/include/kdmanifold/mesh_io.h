// SPDX-License-Identifier: MIT
// Reads and writes OBJ, STL, PLY and OFF.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "kdmanifold/mesh.h"
#include "kdmanifold/warnings.h"

namespace kdm {

enum class MeshFormat {
  kObj,  ///< Wavefront OBJ: `v` and `f`, anything else is ignored
  kStl,  ///< STL, binary or ASCII; written binary
  kPly,  ///< PLY, ASCII or binary of either byte order; written binary little endian
  kOff   ///< OFF in text, also with colours or normals
};

/// Returns the format that a file name's extension stands for (any case). Throws `kIoError` for
/// others.
MeshFormat format_from_path(std::string_view path);

/// Reads a mesh from a file. Polygons are cut into triangles over their own corners, concave ones
/// properly; only geometry is read (no materials, no colours, groups are ignored). STL facets come
/// as three vertices each. A file without faces gives a mesh without faces. What the content is for
/// certain counts, not the name's extension; text may be UTF-8 or UTF-16. Faces with fewer than
/// three corners, or with a coordinate that is not finite, are skipped; `warnings`, unless it is
/// null, becomes the list of what was skipped or assumed. Linear in the bytes; files of
/// 4 GiB and more are refused. Throws `kIoError` if the file cannot be read, `kParseError`, with
/// the line or byte, if its content is malformed (an index out of range, an end too early, all
/// faces skipped) or something else (an archive, a web page), and `kOutOfMemory`.
Mesh read_mesh(const std::string& path, std::vector<Warning>* warnings = nullptr);

/// Reads a mesh from the content of a file, as `read_mesh` does; `name` is what messages call it.
/// `format` is a hint: it counts where the content fits no format for certain.
Mesh parse_mesh(std::string_view bytes, MeshFormat format, std::string_view name = "input",
                std::vector<Warning>* warnings = nullptr);

/// How the 32-bit coordinates are written in text (OBJ, OFF).
enum class Digits {
  kShortest,  ///< as few digits as read back as the same 32-bit number
  kExact  ///< as many digits as read back as the same number in 64 bits too: for programs that read
          ///< 64 bits and must not see the surface moved, as after `Strict::kEmbedded`
};

/// Writes a mesh; the extension decides the format. Positions are written as 32-bit floats; the
/// same mesh gives the same bytes on every platform. Quads stay quads, in STL they become two
/// triangles. The file appears complete or not at all: it is written under another name beside its
/// place. Throws `kIoError`, and `kInvalidMesh` if a coordinate is not finite in 32 bits or a face
/// names a vertex that does not exist.
void write_mesh(const std::string& path, const Mesh& mesh, Digits digits = Digits::kShortest);

/// Writes a mesh into memory, as `write_mesh` does into a file.
std::string format_mesh(const Mesh& mesh, MeshFormat format, Digits digits = Digits::kShortest);

}  // namespace kdm
