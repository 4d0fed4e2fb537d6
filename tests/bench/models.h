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

/// The named files; a folder stands for all files in it that the library can read, sorted by name.
/// Nothing named: the generated scenes (sphere, rings, thin glass, cheese, street), as PLY.
std::vector<Model> load_models(const std::vector<std::string>& paths);

}  // namespace kdm::bench
