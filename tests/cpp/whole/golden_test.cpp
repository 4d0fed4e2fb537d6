// SPDX-License-Identifier: MIT
// Same input, options and version, same bytes: hashes of results, which every compiler, every
// optimisation level and WebAssembly (tests/js reads the same file) must reproduce.
//
// After an intended change of results: KDM_UPDATE_GOLDEN=1 kdmanifold_tests --gtest_filter=Golden.*
// writes tests/golden/hashes.json anew; look at the difference before committing it.
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "kdmanifold/kdmanifold.h"
#include "support/mesh_assert.h"
#include "support/paths.h"

namespace kdm {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

using paths::kTests;
const fs::path kHashes = kTests / "golden" / "hashes.json";

// FNV-1a, 64 bits, over 32-bit little-endian words: positions as floats, then triangles, quads
// and source faces.
class Hash {
 public:
  void add(std::uint32_t word) {
    for (int shift = 0; shift < 32; shift += 8) {
      state_ = (state_ ^ (word >> shift & 0xffu)) * 0x100000001b3u;
    }
  }
  void add(double coordinate) {
    const auto single = static_cast<float>(coordinate);
    std::uint32_t word = 0;
    std::memcpy(&word, &single, sizeof word);
    add(word);
  }
  std::string text() const {
    std::string digits(16, '0');
    for (std::size_t i = 0; i < 16; ++i) {
      digits[i] = "0123456789abcdef"[state_ >> (60 - 4 * i) & 15u];
    }
    return digits;
  }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325u;
};

std::string hash_of(const Mesh& mesh) {
  Hash hash;
  for (const Vec3& p : mesh.positions) {
    for (int axis = 0; axis < 3; ++axis) hash.add(p[axis]);
  }
  for (const Triangle& t : mesh.triangles) {
    for (const Index v : t) hash.add(v);
  }
  for (const Quad& q : mesh.quads) {
    for (const Index v : q) hash.add(v);
  }
  for (const Index face : mesh.source_faces) hash.add(face);
  return hash.text();
}

template <typename Enum>
Enum pick(const json& entry, const char* key, const std::map<std::string, Enum>& values) {
  return values.at(entry.at(key).get<std::string>());
}

// A mesh that is built and reduced as users get it.
Mesh reduced_result_of(const json& entry) {
  const Mesh input = read_mesh((kTests / "data" / entry.at("input").get<std::string>()).string());
  return make_manifold(
      input,
      {.build = {.relative_tolerance = entry.at("relativeTolerance")},
       .reduction = {.target_triangles = entry.at("targetTriangles").get<std::vector<Index>>()}});
}

Mesh result_of(const json& entry) {
  if (entry.contains("relativeTolerance")) return reduced_result_of(entry);
  BuildOptions options;
  options.strategy = pick<SplitStrategy>(entry, "strategy",
                                         {{"adaptive", SplitStrategy::kAdaptive},
                                          {"octree", SplitStrategy::kOctree},
                                          {"feature", SplitStrategy::kFeature},
                                          {"median", SplitStrategy::kMedian},
                                          {"uniform", SplitStrategy::kUniform}});
  options.inside = pick<InsideRule>(entry, "inside",
                                    {{"positive", InsideRule::kPositive},
                                     {"odd", InsideRule::kOdd},
                                     {"nonzero", InsideRule::kNonzero}});
  options.pairing = pick<Pairing>(entry, "pairing",
                                  {{"trace", Pairing::kTrace},
                                   {"hermite", Pairing::kHermite},
                                   {"inside", Pairing::kInside},
                                   {"outside", Pairing::kOutside}});
  options.depth = entry.at("depth");
  const Mesh input = read_mesh((kTests / "data" / entry.at("input").get<std::string>()).string());
  return extract(build_grid(input, options), {.quads = entry.at("quads")});
}

// What is hashed: every input under a few options that between them use every branch.
json all_entries() {
  json entries = json::array();
  const auto add = [&](const std::string& input, const char* strategy, int depth,
                       const char* inside, const char* pairing, bool quads) {
    entries.push_back({{"input", input},
                       {"strategy", strategy},
                       {"depth", depth},
                       {"inside", inside},
                       {"pairing", pairing},
                       {"quads", quads}});
  };
  for (const std::string name : {"cube", "cube_rotated", "torus", "sphere", "thin_walled_box",
                                 "overlapping_cubes", "integer_tetrahedra", "voxels"}) {
    const std::string input = "golden/" + name + ".obj";
    add(input, "uniform", 9, "positive", "trace", true);
    add(input, "octree", 13, "positive", "trace", false);
    add(input, "median", 18, "positive", "trace", false);
    add(input, "adaptive", 15, "positive", "trace", false);
    add(input, "feature", 16, "positive", "trace", false);
    add(input, "uniform", 11, "odd", "hermite", false);
    add(input, "median", 12, "nonzero", "inside", false);
    add(input, "uniform", 10, "positive", "outside", false);
  }
  const auto add_reduced = [&](const std::string& input, double tolerance,
                               const std::vector<Index>& targets) {
    entries.push_back(
        {{"input", input}, {"relativeTolerance", tolerance}, {"targetTriangles", targets}});
  };
  for (const std::string name : {"cube_rotated", "torus", "sphere", "overlapping_cubes"}) {
    const std::string input = "golden/" + name + ".obj";
    add_reduced(input, 0.002, {});
    add_reduced(input, 0.02, {});
    add_reduced(input, 0.01, {200, 100});
  }
  return entries;
}

TEST(Golden, ResultsAreTheSameEverywhere) {
  if (std::getenv("KDM_UPDATE_GOLDEN") != nullptr) {
    json entries = all_entries();
    for (json& entry : entries) {
      const Mesh out = result_of(entry);
      entry["vertices"] = out.positions.size();
      entry["triangles"] = out.triangles.size();
      entry["hash"] = hash_of(out);
    }
    std::ofstream(kHashes) << entries.dump(1) << '\n';
  }
  std::ifstream stream(kHashes);
  ASSERT_TRUE(stream) << kHashes;
  const json entries = json::parse(stream);
  EXPECT_EQ(entries.size(), all_entries().size());
  for (const json& entry : entries) {
    SCOPED_TRACE(entry.dump());
    const Mesh out = result_of(entry);
    EXPECT_TRUE(check::is_two_manifold(out));
    EXPECT_EQ(out.positions.size(), entry.at("vertices"));
    EXPECT_EQ(out.triangles.size(), entry.at("triangles"));
    EXPECT_EQ(hash_of(out), entry.at("hash"));
  }
}

}  // namespace
}  // namespace kdm
