// SPDX-License-Identifier: MIT
// Reads grids from files and writes them. This is apart from load_grid.cpp and save_grid.cpp
// because the WebAssembly build has no files.

#include <new>

#include "io/files.h"
#include "kdmanifold/error.h"
#include "kdmanifold/grid_io.h"
#include "text/compose.h"
#include "text/lower_case.h"

namespace kdm {
namespace {

constexpr std::string_view kExtension = ".kdgrid";

}  // namespace

bool names_a_grid(std::string_view path) {
  if (path.size() < kExtension.size()) return false;
  return lower_case(path.substr(path.size() - kExtension.size())) == kExtension;
}

void write_grid(const std::string& path, const Grid& grid) {
  if (!names_a_grid(path)) {
    throw Error(ErrorCode::kIoError,
                compose("{}: the file's name does not end in {}", path, kExtension));
  }
  const std::vector<std::uint8_t> bytes = save_grid(grid);
  write_file(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

Grid read_grid(const std::string& path) try {
  const std::string bytes = read_file(path);
  return load_grid({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, path);
} catch (const std::bad_alloc&) {
  throw Error(ErrorCode::kOutOfMemory, compose("{}: not enough memory to read it", path));
}

}  // namespace kdm
