// SPDX-License-Identifier: MIT
// Picks the reader or writer of a format, and checks what can be written. formats.h says how
// reading and writing go.
#include "kdmanifold/mesh_io.h"

#include <cmath>
#include <new>

#include "io/decode_text.h"
#include "io/formats.h"
#include "io/sniff.h"
#include "io/text_scanner.h"
#include "kdmanifold/error.h"
#include "mesh/check_indices.h"
#include "text/compose.h"
#include "text/lower_case.h"

namespace kdm {
namespace {

// Throws `kInvalidMesh` if the mesh cannot be written: files hold coordinates as 32-bit floats, and
// a PLY file holds vertex numbers as signed 32-bit integers.
void check_writable(const Mesh& mesh) {
  if (mesh.positions.size() > 0x7fffffffu ||
      std::uint64_t{mesh.triangles.size()} + 2 * std::uint64_t{mesh.quads.size()} > 0xffffffffu) {
    throw Error(ErrorCode::kInvalidMesh, "the mesh is too large for a file: 2^31 vertices or more");
  }
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const double value = mesh.positions[i][axis];
      if (std::isfinite(static_cast<float>(value))) continue;
      throw Error(ErrorCode::kInvalidMesh,
                  compose("positions[{}].{} is {}, which is no finite 32-bit number; scale the "
                          "mesh down",
                          i, "xyz"[axis], value));
    }
  }
  check_indices(mesh);
  const std::size_t corners = 3 * mesh.triangles.size() + 4 * mesh.quads.size();
  if (!mesh.corner_normals.empty() && mesh.corner_normals.size() != corners) {
    throw Error(ErrorCode::kInvalidMesh,
                compose("corner_normals: there are {}, but the faces have {} corners",
                        mesh.corner_normals.size(), corners));
  }
  for (std::size_t i = 0; i < mesh.corner_normals.size(); ++i) {
    for (const float value : mesh.corner_normals[i]) {
      if (std::isfinite(value)) continue;
      throw Error(ErrorCode::kInvalidMesh,
                  compose("corner_normals[{}] has {}; it must be finite", i, value));
    }
  }
}

Mesh parse_as(MeshFormat format, std::string_view bytes, std::string_view name,
              Warnings& warnings) {
  switch (format) {
    case MeshFormat::kObj:
      return parse_obj(bytes, name, warnings);
    case MeshFormat::kStl:
      return parse_stl(bytes, name, warnings);
    case MeshFormat::kPly:
      return parse_ply(bytes, name, warnings);
    case MeshFormat::kOff:
      return parse_off(bytes, name, warnings);
  }
  throw Error(ErrorCode::kInvalidOption, "format is not a MeshFormat");
}

}  // namespace

MeshFormat format_from_path(std::string_view path) {
  const std::size_t slash = path.find_last_of("/\\");
  const std::string_view file = slash == std::string_view::npos ? path : path.substr(slash + 1);
  const std::size_t dot = file.rfind('.');
  const std::string extension =
      dot == std::string_view::npos ? "" : lower_case(file.substr(dot + 1));
  if (extension == "obj") return MeshFormat::kObj;
  if (extension == "stl") return MeshFormat::kStl;
  if (extension == "ply") return MeshFormat::kPly;
  if (extension == "off") return MeshFormat::kOff;
  throw Error(ErrorCode::kIoError,
              compose("{}: the file's name ends in none of .obj, .stl, .ply and .off", path));
}

Mesh parse_mesh(std::string_view bytes, MeshFormat format, std::string_view name,
                std::vector<Warning>* warnings) {
  if (std::uint64_t{bytes.size()} > kLargestFile) {
    throw Error(ErrorCode::kParseError, compose("{}: byte {}: files of 4 GiB and more are not "
                                                "supported",
                                                name, kLargestFile));
  }
  try {
    Warnings collected;
    std::string decoded;
    if (const auto order = utf16_order(bytes); order && !is_whole_binary_stl(bytes)) {
      decoded = utf8_from_utf16(bytes, *order);
      bytes = decoded;
    }
    const Content content = sniff(bytes);
    if (!content.foreign.empty()) {
      throw Error(ErrorCode::kParseError,
                  compose("{}: byte 0: the file is {}", name, content.foreign));
    }
    Mesh mesh = parse_as(content.format.value_or(format), bytes, name, collected);
    if (mesh.triangles.empty()) collected.fail_if_skipped(name);
    if (warnings != nullptr) *warnings = collected.take();
    return mesh;
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::kOutOfMemory, compose("{}: not enough memory to read it", name));
  }
}

std::string format_mesh(const Mesh& mesh, MeshFormat format, Digits digits) {
  check_writable(mesh);
  try {
    switch (format) {
      case MeshFormat::kObj:
        return format_obj(mesh, digits);
      case MeshFormat::kStl:
        return format_stl(mesh);
      case MeshFormat::kPly:
        return format_ply(mesh);
      case MeshFormat::kOff:
        return format_off(mesh, digits);
    }
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::kOutOfMemory, "not enough memory to write the mesh");
  }
  throw Error(ErrorCode::kInvalidOption, "format is not a MeshFormat");
}

}  // namespace kdm
