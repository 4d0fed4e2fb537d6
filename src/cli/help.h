// SPDX-License-Identifier: MIT
// What --help prints.
#pragma once

#include <string>

namespace kdm::cli {

/// Writes usage, all options with their meaning, ranges and defaults, and the exit status. The Node
/// command line prints the same text.
std::string help_text();

}  // namespace kdm::cli
