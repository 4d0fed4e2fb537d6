// SPDX-License-Identifier: MIT
#include "models.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>

#include "kdmanifold/error.h"
#include "street.h"
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

struct Scene {
  const char* name;
  std::function<Mesh()> make;
  bool by_default;
};

const std::vector<Scene>& scenes() {
  using namespace shapes;
  static const std::vector<Scene> list = {
      {"icosphere_82k", [] { return icosphere(6); }, true},
      {"torus_chain_100k", [] { return subdivided(torus_chain(20)); }, true},
      {"glass_178k", [] { return subdivided(subdivided(subdivided(glass()))); }, true},
      {"swiss_cheese_64k", [] { return swiss_cheese(200); }, true},
      {"street_88k", [] { return street(); }, true},
      {"street_apart_88k", [] { return street_apart(); }, true},
      {"thin_box", [] { return thin_walled_box(); }, false},
      {"nested_spheres", [] { return nested_spheres(); }, false},
      {"torus_chain", [] { return torus_chain(6); }, false}};
  return list;
}

Model generated(const Scene& scene) {
  return {std::string(scene.name) + ".ply", format_mesh(scene.make(), MeshFormat::kPly),
          MeshFormat::kPly};
}

Model scene_named(const std::string& name) {
  std::string known;
  for (const Scene& scene : scenes()) {
    if (name == scene.name) return generated(scene);
    known += std::string(known.empty() ? "" : ", ") + scene.name;
  }
  throw Error(ErrorCode::kInvalidOption, "scene '" + name + "' is none of " + known);
}

constexpr std::string_view kScenePrefix = "scene:";

}  // namespace

std::vector<Model> load_models(const std::vector<std::string>& paths) {
  std::vector<Model> models;
  for (const Scene& scene : scenes()) {
    if (paths.empty() && scene.by_default) models.push_back(generated(scene));
  }
  for (const std::string& path : paths) {
    if (path.rfind(kScenePrefix, 0) == 0) {
      models.push_back(scene_named(path.substr(kScenePrefix.size())));
      continue;
    }
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

Model subdivided_model(const Model& model, int times) {
  Mesh mesh = parse_mesh(model.bytes, model.format, model.name);
  for (int i = 0; i < times; ++i) mesh = shapes::subdivided(std::move(mesh));
  return {fs::path(model.name).stem().string() + "_x" + std::to_string(1 << (2 * times)) + ".ply",
          format_mesh(mesh, MeshFormat::kPly), MeshFormat::kPly};
}

}  // namespace kdm::bench
