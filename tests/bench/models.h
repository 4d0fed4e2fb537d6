// SPDX-License-Identifier: MIT
// What the benchmark runs on: files, the files of a folder, or generated shapes.
#pragma once

#include <string>
#include <vector>

#include "kdmanifold/mesh_io.h"

namespace kdm::bench {

struct Model {
  std::string name;
  std::string bytes;  ///< the file's content
  MeshFormat format = MeshFormat::kPly;
};

/// The named files; a folder stands for all files in it that the library can read, sorted by name,
/// "scene:thin_box" and the like for a generated scene. Nothing named: the large generated scenes
/// (sphere, rings, thin glass, cheese, two streets).
std::vector<Model> load_models(const std::vector<std::string>& paths);

/// Each triangle cut in four, `times` times; points move by no more than the rounding to 32-bit
/// floats, which is what files hold.
Model subdivided_model(const Model& model, int times);

}  // namespace kdm::bench
