// SPDX-License-Identifier: MIT
// The work for one input.
#pragma once

#include "cli/plan.h"
#include "cli/progress_line.h"
#include "cli/report.h"

namespace kdm::cli {

/// Reads, analyzes, builds (or loads), extracts, writes, as far as it is asked for. What can be
/// refused before the work is. Throws `Error` whose message begins with the name of a file.
RunReport convert(const Command& command, const Task& task, ProgressLine& progress);

}  // namespace kdm::cli
