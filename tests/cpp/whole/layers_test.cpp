// SPDX-License-Identifier: MIT
// The source tree keeps its order: a room includes only rooms before it, and no circle closes.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "support/paths.h"

namespace {

namespace fs = std::filesystem;

using kdm::paths::kRoot;
const fs::path kSource = kRoot / "src";

// The rooms of the library in their order. Each may include itself and what stands before it.
const std::vector<std::string> kRooms = {"include/kdmanifold",
                                         "text",
                                         "options",
                                         "threads",
                                         "geometry",
                                         "mesh",
                                         "io",
                                         "prepare",
                                         "analyze",
                                         "grid",
                                         "grid/saved",
                                         "inside",
                                         "split",
                                         "link",
                                         "construct",
                                         "extract/dual",
                                         "extract/place",
                                         "extract/mend",
                                         "extract/embed",
                                         "extract",
                                         "csg",
                                         "merge",
                                         "reduce",
                                         "simplify",
                                         "make",
                                         "account"};

// What stands outside of the library sees its public headers only.
const std::vector<std::string> kOutside = {"src/cli", "wasm"};

std::string room_of(const std::string& file) { return file.substr(0, file.rfind('/')); }

std::vector<fs::path> sources_below(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
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

// The quoted includes of a file.
std::vector<std::string> includes_of(const fs::path& file) {
  std::vector<std::string> names;
  for (const std::string& line : lines_of(file)) {
    if (line.rfind("#include \"", 0) == 0)
      names.push_back(line.substr(10, line.find('"', 10) - 10));
  }
  return names;
}

// Every source of the library by its path below src, and the paths of what it includes.
std::map<std::string, std::vector<std::string>> includes_by_file() {
  std::map<std::string, std::vector<std::string>> found;
  for (const fs::path& path : sources_below(kSource)) {
    const std::string file = fs::relative(path, kSource).generic_string();
    if (file.rfind("cli/", 0) == 0) continue;
    std::vector<std::string>& names = found[file];
    for (const std::string& name : includes_of(path)) {
      const bool is_public = name.rfind("kdmanifold/", 0) == 0;
      names.push_back(is_public ? "include/" + name : name);
    }
  }
  return found;
}

TEST(Layers, EveryFileStandsInARoom) {
  std::set<std::string> used;
  for (const auto& [file, names] : includes_by_file()) {
    EXPECT_TRUE(std::count(kRooms.begin(), kRooms.end(), room_of(file))) << file;
    used.insert(room_of(file));
  }
  for (const std::string& room : kRooms) EXPECT_TRUE(used.count(room)) << room << " is empty";
}

TEST(Layers, NothingIncludesUpwards) {
  const auto rank = [](const std::string& file) {
    return std::find(kRooms.begin(), kRooms.end(), room_of(file)) - kRooms.begin();
  };
  const auto files = includes_by_file();
  EXPECT_GT(files.size(), 100u);
  for (const auto& [file, names] : files) {
    for (const std::string& name : names) {
      if (name == "include/kdmanifold/version.h") continue;  // made from version.h.in
      EXPECT_TRUE(files.count(name)) << file << " includes " << name << ", which is no source";
      EXPECT_LE(rank(name), rank(file)) << file << " includes " << name;
    }
  }
}

// A header and the source of the same name are one concept; none may need another that needs it.
TEST(Layers, NoCircleCloses) {
  std::map<std::string, std::set<std::string>> needs;
  const auto concept_of = [](const std::string& file) { return file.substr(0, file.rfind('.')); };
  for (const auto& [file, names] : includes_by_file()) {
    for (const std::string& name : names) {
      if (concept_of(name) != concept_of(file)) needs[concept_of(file)].insert(concept_of(name));
    }
  }
  // Concepts that need nothing that is left go, again and again; what stays is in circles.
  for (bool changed = true; changed;) {
    changed = false;
    for (auto entry = needs.begin(); entry != needs.end();) {
      std::set<std::string>& left = entry->second;
      for (auto name = left.begin(); name != left.end();) {
        name = needs.count(*name) ? std::next(name) : left.erase(name);
      }
      if (left.empty()) {
        entry = needs.erase(entry);
        changed = true;
      } else {
        ++entry;
      }
    }
  }
  for (const auto& [name, left] : needs) {
    for (const std::string& other : left) ADD_FAILURE() << "circle: " << name << " -> " << other;
  }
}

TEST(Layers, TheOutsideSeesPublicHeadersOnly) {
  for (const std::string& folder : kOutside) {
    const std::string own = fs::path(folder).filename().string() + "/";
    ASSERT_FALSE(sources_below(kRoot / folder).empty()) << folder;
    for (const fs::path& file : sources_below(kRoot / folder)) {
      for (const std::string& name : includes_of(file)) {
        const bool allowed = name.rfind("kdmanifold/", 0) == 0 || name.rfind(own, 0) == 0 ||
                             fs::exists(file.parent_path() / name);
        EXPECT_TRUE(allowed) << file << " includes " << name;
      }
    }
  }
}

// Paths in backticks of the table that maps the paper to the sources: `room/file`, `room/file.h`,
// `room/room`.
TEST(Layers, TheMapNamesSourcesThatExist) {
  const std::regex path("`([a-z_]+(?:/[a-z_]+)+)(\\.h)?`");
  int named = 0;
  for (const std::string& line : lines_of(kSource / "README.md")) {
    if (line.rfind("| ", 0) != 0) continue;
    for (std::sregex_iterator match(line.begin(), line.end(), path), end; match != end; ++match) {
      const std::string name = (*match)[1].str();
      ++named;
      EXPECT_TRUE(fs::exists(kSource / (name + ".h")) || fs::exists(kSource / (name + ".cpp")) ||
                  fs::is_directory(kSource / name))
          << name;
    }
  }
  EXPECT_GT(named, 40);
}

TEST(Layers, TheLibraryPrintsNothing) {
  for (const auto& [file, names] : includes_by_file()) {
    for (const std::string& line : lines_of(kSource / file)) {
      for (const char* word : {"<iostream>", "std::cout", "std::cerr", " printf(", "fmt::print("}) {
        EXPECT_EQ(line.find(word), std::string::npos) << file << ": " << line;
      }
    }
  }
}

TEST(Layers, EveryFileIsShortAndNamesItsLicence) {
  for (const fs::path& folder : {kSource, kRoot / "wasm"}) {
    for (const fs::path& file : sources_below(folder)) {
      const std::vector<std::string> lines = lines_of(file);
      ASSERT_FALSE(lines.empty()) << file;
      EXPECT_EQ(lines[0], "// SPDX-License-Identifier: MIT") << file;
      EXPECT_LE(lines.size(), 600u) << file;
    }
  }
}

}  // namespace
