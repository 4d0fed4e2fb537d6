// SPDX-License-Identifier: MIT
// Reads the command line's arguments.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "cli/command.h"

namespace kdm::cli {

/// A mistake in the arguments; `what()` is one line.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads the arguments, without the program's name. Options are `--name VALUE`, `--name=VALUE`,
/// `-o VALUE`; names may be written in camel case. All that follows `--` are inputs. Throws
/// `UsageError` for an option that does not exist, a value that is missing or not legal, an option
/// given twice, or options that do not go together. Looks at no file.
Command parse_command(const std::vector<std::string>& arguments);

/// Reads the whole text as a finite number; NaN if it is none.
double to_number(const std::string& text);

/// Reads the numbers between commas, each as above.
std::vector<double> to_numbers(const std::string& text);

}  // namespace kdm::cli
