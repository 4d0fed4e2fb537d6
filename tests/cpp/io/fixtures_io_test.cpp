// SPDX-License-Identifier: MIT
// The files of tests/data and tests/repro: read, measured, and listed with their source.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "kdmanifold/mesh_io.h"
#include "support/mesh_assert.h"
#include "support/paths.h"

namespace kdm {
namespace {

namespace fs = std::filesystem;
using paths::kTests;

Mesh read(const char* file) { return read_mesh((kTests / file).string()); }

TEST(Fixtures, ThePrismIsTheSameInEveryFormat) {
  for (const char* file : {"data/l_prism.obj", "data/l_prism.off", "data/l_prism_ascii.ply",
                           "data/l_prism_big_endian.ply", "data/l_prism_ascii.stl"}) {
    SCOPED_TRACE(file);
    const Mesh mesh = read(file);
    const MeshReport report = describe(mesh);
    EXPECT_EQ(report.triangles, 2u * 4 + 6 * 2);
    EXPECT_DOUBLE_EQ(report.volume, 3);
    EXPECT_DOUBLE_EQ(report.area, 2 * 3 + 8);
    EXPECT_EQ(report.bounds.max, Vec3(2, 2, 1));
    ASSERT_EQ(mesh.source_faces.size(), 20u);
    if (std::string(file).find(".stl") != std::string::npos) {
      EXPECT_EQ(report.vertices, 60u);
      EXPECT_EQ(mesh.source_faces.back(), 19u);
    } else {
      EXPECT_EQ(report.vertices, 12u);
      EXPECT_TRUE(check::is_two_manifold(mesh));
      EXPECT_EQ(mesh.source_faces.front(), 0u);
      EXPECT_EQ(mesh.source_faces.back(), 7u);
    }
  }
}

TEST(Fixtures, PolygonWithASpike) {
  const MeshReport report = describe(read("repro/polygon_spike.obj"));
  EXPECT_DOUBLE_EQ(report.volume, 4);
  EXPECT_DOUBLE_EQ(report.area, 16);
  EXPECT_EQ(report.triangles, 5u * 2 + 4);
}

TEST(Fixtures, EveryFileIsListed) {
  std::ifstream stream(kTests / "data/SOURCES.md");
  std::ostringstream text;
  text << stream.rdbuf();
  for (const char* folder : {"data", "repro"}) {
    for (const fs::directory_entry& entry : fs::directory_iterator(kTests / folder)) {
      const std::string name = entry.path().filename().string();
      if (!entry.is_regular_file() || name == "SOURCES.md") continue;
      EXPECT_NE(text.str().find(name + "`"), std::string::npos) << name << " has no source";
    }
  }
}

}  // namespace
}  // namespace kdm
