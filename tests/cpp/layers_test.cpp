// SPDX-License-Identifier: MIT
// The source tree keeps its layers: geometry <- mesh <- grid <- {build, extract} <- cli, wasm.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = fs::path(__FILE__).parent_path().parent_path().parent_path();

// What a folder's files may include besides <...> and neighbours named without a folder.
const std::map<std::string, std::set<std::string>> kMayInclude = {
    {"src/include/kdmanifold", {"kdmanifold"}},
    {"src/geometry", {"kdmanifold", "geometry"}},
    {"src/mesh", {"kdmanifold", "geometry", "mesh"}},
    {"src/grid", {"kdmanifold", "geometry", "mesh", "grid"}},
    {"src/build", {"kdmanifold", "geometry", "mesh", "grid", "build"}},
    {"src/extract", {"kdmanifold", "geometry", "mesh", "grid", "extract"}},
    {"src/cli", {"kdmanifold", "cli"}},
    {"wasm", {"kdmanifold", "wasm"}},
};

std::vector<fs::path> sources_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".h" || extension == ".cpp") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> lines_of(const fs::path& file) {
  std::ifstream stream(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(Layers, EveryFolderIsListed) {
  for (const fs::directory_entry& entry : fs::directory_iterator(kRoot / "src")) {
    if (!entry.is_directory() || entry.path().filename() == "include") continue;
    const std::string name = "src/" + entry.path().filename().string();
    EXPECT_TRUE(kMayInclude.count(name)) << name << " has no place in the order of layers";
  }
}

TEST(Layers, NothingIncludesUpwards) {
  for (const auto& [folder, allowed] : kMayInclude) {
    ASSERT_TRUE(fs::is_directory(kRoot / folder)) << folder;
    EXPECT_FALSE(sources_in(kRoot / folder).empty()) << folder;
    for (const fs::path& file : sources_in(kRoot / folder)) {
      for (const std::string& line : lines_of(file)) {
        if (line.rfind("#include \"", 0) != 0) continue;
        const std::string name = line.substr(10, line.find('"', 10) - 10);
        const std::size_t slash = name.find('/');
        if (slash == std::string::npos) {
          EXPECT_TRUE(fs::exists(kRoot / folder / name)) << file << " includes " << name;
        } else {
          EXPECT_TRUE(allowed.count(name.substr(0, slash))) << file << " includes " << name;
        }
      }
    }
  }
}

TEST(Layers, TheLibraryPrintsNothing) {
  for (const auto& [folder, allowed] : kMayInclude) {
    if (folder == "src/cli" || folder == "wasm") continue;
    for (const fs::path& file : sources_in(kRoot / folder)) {
      for (const std::string& line : lines_of(file)) {
        for (const char* word :
             {"<iostream>", "std::cout", "std::cerr", " printf(", "fmt::print("}) {
          EXPECT_EQ(line.find(word), std::string::npos) << file << ": " << line;
        }
      }
    }
  }
}

TEST(Layers, EveryFileIsShortAndNamesItsLicence) {
  for (const auto& [folder, allowed] : kMayInclude) {
    for (const fs::path& file : sources_in(kRoot / folder)) {
      const std::vector<std::string> lines = lines_of(file);
      ASSERT_FALSE(lines.empty()) << file;
      EXPECT_EQ(lines[0], "// SPDX-License-Identifier: MIT") << file;
      EXPECT_LE(lines.size(), 600u) << file;
    }
  }
}

}  // namespace
