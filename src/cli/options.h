// SPDX-License-Identifier: MIT
// The command line's options, as a table: names, legal values and help are written there and
// nowhere else. They are the JavaScript options' names with dashes (web/src/options.ts).
#pragma once

#include <stdexcept>
#include <string>

#include "kdmanifold/kdmanifold.h"

namespace kdm::cli {

/// What the command line asks for.
struct Command {
  std::string input;
  std::string output;     ///< empty: none is written
  std::string save_grid;  ///< where the grid goes; empty: nowhere
  BuildOptions build;
  ExtractOptions extract;
  bool json = false;   ///< print the report as JSON
  bool check = false;  ///< verify the output; exit status 1 if it is not 2-manifold
  bool stats = false;  ///< describe the input's defects
  std::string answer;  ///< not empty: print this instead of working (--help, --version)
};

/// Is there a grid to be made? Not with --stats alone.
inline bool converts(const Command& command) {
  return !command.stats || command.check || !command.output.empty() || !command.save_grid.empty();
}

/// A mistake in the arguments; `what()` is one line.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws `UsageError`.
Command parse_command(int argc, const char* const* argv);

/// The words of the table, e.g. "octree".
const char* word_of(SplitStrategy strategy);
const char* word_of(InsideRule rule);
const char* word_of(Pairing pairing);

}  // namespace kdm::cli
