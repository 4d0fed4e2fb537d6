// SPDX-License-Identifier: MIT
// The operands of Boolean operations, as the command line names them.
#pragma once

#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/file_format.h"
#include "cli/report.h"

namespace kdm::cli {

/// One operand: INPUT, or the file of an operation.
struct SolidFile {
  std::string path;
  Transform transform = Transform::Identity();
  std::string operation;  ///< what joins it to all before it, e.g. "--union"; of INPUT empty
};

/// Returns INPUT, with an empty path, and the files of the operations in their order. Throws
/// `UsageError` if a transform is no transform, or if an operand has two.
std::vector<SolidFile> solid_files(const Command& command);

/// Makes what the operations say, which are done from left to right. Adds to the report's
/// `warnings`. Throws `Error`, whose message begins with the file at fault.
MadeManifold make_solids(const Command& command, const std::string& input_name, const Mesh& input,
                         const StepProgress& progress, RunReport& report);

/// Merges the grid in INPUT with those of the operations, from left to right. Throws `Error`, whose
/// message begins with the file at fault.
Grid merge_grids_of(const Command& command, const std::string& input, const Progress& progress);

}  // namespace kdm::cli
