// SPDX-License-Identifier: MIT
// Chooses between the formats of the library and GLB.
#include "cli/mesh_files.h"

#include "cli/files.h"
#include "cli/glb/read.h"
#include "cli/glb/write.h"

namespace kdm::cli {

ReadMesh read_mesh_file(const std::string& path, FileFormat format) {
  const std::string bytes = read_all(path);
  const std::string name = input_name(path);
  if (format != FileFormat::kGlb) {
    ReadMesh read;
    read.mesh = parse_mesh(bytes, library_format(format), name, &read.warnings);
    return read;
  }
  glb::Scene scene = glb::read(bytes, name);
  return {std::move(scene.mesh), std::move(scene.warnings)};
}

Grid read_grid_file(const std::string& path) {
  const std::string bytes = read_all(path);
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  return load_grid({data, bytes.size()}, path);
}

std::string format_file(const Mesh& mesh, FileFormat format, Digits digits) {
  return format == FileFormat::kGlb ? glb::write(mesh)
                                    : format_mesh(mesh, library_format(format), digits);
}

void write_grid_file(const std::string& path, const Grid& grid) {
  const std::vector<std::uint8_t> bytes = save_grid(grid);
  write_all(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace kdm::cli
