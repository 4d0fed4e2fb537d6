// SPDX-License-Identifier: MIT
// What is to be done, one input after the other.
#pragma once

#include <string>
#include <vector>

#include "cli/command.h"

namespace kdm::cli {

/// One input and its result.
struct Task {
  std::string input;     ///< a path, or `-`
  std::string output;    ///< a path, or `-`; empty: no mesh is written
  bool is_grid = false;  ///< a saved grid is to be loaded
};

/// Returns the path of a level of the result, from 1 on: `name.1.obj` for `name.obj`.
std::string level_path(const std::string& output, std::size_t level);

/// Expands patterns, leaves out what is given twice and names the results. Throws `UsageError` if a
/// pattern fits no file, if the options do not go together with so many inputs or with grids, or if
/// two results would have one name; and `Error` if --out-dir can hold no files.
std::vector<Task> plan(const Command& command);

}  // namespace kdm::cli
