// SPDX-License-Identifier: MIT
// Reads meshes from files and writes them. Apart from mesh_io.cpp, since the WebAssembly build has
// no files.

#include <new>

#include "io/files.h"
#include "kdmanifold/error.h"
#include "kdmanifold/mesh_io.h"
#include "text/compose.h"

namespace kdm {

Mesh read_mesh(const std::string& path, std::vector<Warning>* warnings) {
  const MeshFormat format = format_from_path(path);
  try {
    return parse_mesh(read_file(path), format, path, warnings);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::kOutOfMemory, compose("{}: not enough memory to read it", path));
  }
}

void write_mesh(const std::string& path, const Mesh& mesh, Digits digits) {
  write_file(path, format_mesh(mesh, format_from_path(path), digits));
}

}  // namespace kdm
