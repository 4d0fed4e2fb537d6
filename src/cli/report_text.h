// SPDX-License-Identifier: MIT
// The account of one run as a few lines for people.
#pragma once

#include <string>

#include "cli/report.h"

namespace kdm::cli {

/// Writes the lines; the Node command line writes the same.
std::string report_as_text(const RunReport& report, const Command& command, const Task& task);

}  // namespace kdm::cli
