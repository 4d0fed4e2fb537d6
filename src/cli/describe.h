// SPDX-License-Identifier: MIT
// What --describe prints: all options and reports, for scripts that make other things of them.
#pragma once

#include <string>

namespace kdm::cli {

/// Writes one JSON object. `options`: under `build`, `extract`, `analyze`, `files` and `report`
/// (those that only command lines have) the options with their JavaScript name, the flag that is
/// typed, type, words, default, range, unit and help. `reports`: the types of reports with their
/// meaning and their keys in order. `check` and `defects`: the keys of these parts of a run's
/// report. `help`: what --help prints.
std::string description();

}  // namespace kdm::cli
