// SPDX-License-Identifier: MIT
// Reads the command line's arguments.
#pragma once

#include <stdexcept>

#include "cli/command.h"

namespace kdm::cli {

/// A mistake in the arguments; `what()` is one line.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads the arguments, the program's name first. Throws `UsageError` for an option that does not
/// exist, a value that is not legal, or options that do not go together.
Command parse_command(int argc, const char* const* argv);

}  // namespace kdm::cli
