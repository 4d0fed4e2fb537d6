// SPDX-License-Identifier: MIT
#include "models.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "kdmanifold/error.h"
#include "support/shapes.h"

namespace kdm::bench {
namespace {

namespace fs = std::filesystem;

bool readable(const fs::path& path) {
  try {
    format_from_path(path.string());
    return fs::is_regular_file(path);
  } catch (const Error&) {
    return false;
  }
}

Model from_file(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw Error(ErrorCode::kIoError, path.string() + ": cannot be opened");
  Model model{path.filename().string(), {}, format_from_path(path.string())};
  model.bytes.assign(std::istreambuf_iterator<char>(stream), {});
  return model;
}

Model generated(const std::string& name, const Mesh& mesh) {
  return {name, format_mesh(mesh, MeshFormat::kPly), MeshFormat::kPly};
}

}  // namespace

std::vector<Model> load_models(const std::vector<std::string>& paths) {
  if (paths.empty()) {
    return {generated("icosphere_82k.ply", shapes::icosphere(6)),
            generated("torus_chain_100k.ply", shapes::subdivided(shapes::torus_chain(20))),
            generated("glass_178k.ply",
                      shapes::subdivided(shapes::subdivided(shapes::subdivided(shapes::glass())))),
            generated("swiss_cheese_64k.ply", shapes::swiss_cheese(200)),
            generated("street_88k.ply", shapes::street())};
  }
  std::vector<Model> models;
  for (const std::string& path : paths) {
    if (!fs::is_directory(path)) {
      models.push_back(from_file(path));
      continue;
    }
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(path)) {
      if (readable(entry.path())) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) models.push_back(from_file(file));
  }
  return models;
}

}  // namespace kdm::bench
