// SPDX-License-Identifier: MIT
// A short run of the fuzz targets from a fixed seed, without libFuzzer: part of ctest on every
// compiler. Parsers and loading get damaged copies of what is well-formed, construction gets random
// bytes.
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "grid_seeds.h"
#include "kdmanifold/kdmanifold.h"
#include "support/shapes.h"
#include "targets.h"

namespace {

using kdm::fuzz::Bytes;

// Changes, cuts out, or repeats a few stretches.
void damage(Bytes& bytes, std::mt19937& engine) {
  for (std::uint32_t i = engine() % 4; i > 0 && bytes.size() > 1; --i) {
    const auto at = static_cast<std::ptrdiff_t>(1 + engine() % (bytes.size() - 1));
    const auto length = std::min<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(engine() % 16),
                                                 static_cast<std::ptrdiff_t>(bytes.size()) - at);
    switch (engine() % 4) {
      case 0:
        for (std::ptrdiff_t k = 0; k < length; ++k) {
          bytes[static_cast<std::size_t>(at + k)] = static_cast<std::uint8_t>(engine());
        }
        break;
      case 1:
        bytes.erase(bytes.begin() + at, bytes.begin() + at + length);
        break;
      case 2: {
        const Bytes copy(bytes.begin() + at, bytes.begin() + at + length);
        bytes.insert(bytes.begin() + at, copy.begin(), copy.end());
        break;
      }
      default:
        bytes.resize(static_cast<std::size_t>(at));
    }
  }
}

void smoke_parsers(int rounds) {
  std::mt19937 engine(1);
  const std::string ascii_stl =
      "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
      "endloop\nendfacet\nendsolid s\n";
  const std::string ascii_ply =
      "ply\nformat ascii 1.0\ncomment c\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const std::string obj =
      "# c\ng part\nv 0 0 0\nv 1 0 0 1\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n"
      "f 1/1/1 2//1 3/1 \\\n 4\nf -4 -3 -2\n";
  std::vector<Bytes> corpus;
  const auto add = [&](int format, const std::string& text) {
    Bytes bytes(1, static_cast<std::uint8_t>(format));
    bytes.insert(bytes.end(), text.begin(), text.end());
    corpus.push_back(bytes);
  };
  const kdm::Mesh mesh = kdm::shapes::tetrahedron();
  for (int format = 0; format < 4; ++format) {
    add(format, kdm::format_mesh(mesh, static_cast<kdm::MeshFormat>(format)));
  }
  add(static_cast<int>(kdm::MeshFormat::kObj), obj);
  add(static_cast<int>(kdm::MeshFormat::kStl), ascii_stl);
  add(static_cast<int>(kdm::MeshFormat::kPly), ascii_ply);
  add(static_cast<int>(kdm::MeshFormat::kOff),
      "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
  // What content decides, and what is skipped.
  add(static_cast<int>(kdm::MeshFormat::kStl), "v 0 nan 0\n" + obj + "f 1 2\nf 1 2 3 4\n");
  add(static_cast<int>(kdm::MeshFormat::kObj), ascii_stl + "color 1 0 0\n" + ascii_stl);
  add(static_cast<int>(kdm::MeshFormat::kOff), "nOFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2");
  add(static_cast<int>(kdm::MeshFormat::kOff), "NOFF 2 0 0 0 0 0 1 1 1 2 2 2 1 1 1");
  std::string wide = "\xff\xfe";
  for (const char c : obj) wide += {c, '\0'};
  add(static_cast<int>(kdm::MeshFormat::kObj), wide);
  for (int round = 0; round < rounds; ++round) {
    Bytes bytes = corpus[engine() % corpus.size()];
    damage(bytes, engine);
    kdm::fuzz::parse_bytes(bytes.data(), bytes.size());
  }
}

void smoke_build(int rounds) {
  std::mt19937 engine(2);
  for (int round = 0; round < rounds; ++round) {
    Bytes bytes(4 + 12 * (1 + engine() % 12));
    // Half of the rounds keep to few coordinates, so that planes and corners coincide.
    const std::uint32_t mask = engine() % 2 == 0 ? 3u : 255u;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      bytes[i] = static_cast<std::uint8_t>(engine() & (i < 4 ? 255u : mask));
    }
    kdm::fuzz::build_from_bytes(bytes.data(), bytes.size());
  }
}

void smoke_grids(int rounds) {
  std::mt19937 engine(3);
  const std::vector<Bytes> corpus = kdm::fuzz::grid_seeds();
  for (int round = 0; round < rounds; ++round) {
    Bytes bytes = corpus[engine() % corpus.size()];
    if (round % 2 == 0) {
      damage(bytes, engine);
    } else {
      bytes[engine() % bytes.size()] ^= static_cast<std::uint8_t>(1u << engine() % 8);
    }
    kdm::fuzz::load_bytes(bytes.data(), bytes.size());
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int scale = argc > 1 ? std::atoi(argv[1]) : 1;
  smoke_parsers(20000 * scale);
  smoke_build(400 * scale);
  smoke_grids(3000 * scale);
  std::puts("fuzz smoke run: no fault found");
  return 0;
}
