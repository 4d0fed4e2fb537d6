// SPDX-License-Identifier: MIT
// Reads operands and joins them. solids.ts does the same, word for word.
#include "cli/solids.h"

#include <fmt/format.h>

#include <cmath>

#include "cli/mesh_files.h"
#include "cli/options.h"

namespace kdm::cli {
namespace {

[[noreturn]] void refuse(const RepeatedArgument& argument, const std::string& text) {
  throw UsageError(argument.typed + ": " + text);
}

// Reads twelve numbers, row by row, or sixteen, the last row being that of an affine map.
Transform transform_of(const RepeatedArgument& argument) {
  const std::vector<double> numbers = to_numbers(argument.value);
  bool legal = numbers.size() == 12 || numbers.size() == 16;
  for (const double number : numbers) legal = legal && std::isfinite(number);
  for (std::size_t i = 12; i < numbers.size(); ++i) legal = legal && numbers[i] == (i == 15);
  if (!legal) {
    refuse(argument,
           fmt::format("'{}' is no transform: 12 numbers with commas between them, three rows of "
                       "four, or 16 with 0,0,0,1 at the end",
                       argument.value));
  }
  return Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(numbers.data());
}

Expression operation_of(const std::string& flag, const Expression& a, const Expression& b) {
  return flag == "--union"          ? union_of(a, b)
         : flag == "--intersection" ? intersection(a, b)
         : flag == "--difference"   ? difference(a, b)
                                    : symmetric_difference(a, b);
}

Expression joined(const std::vector<SolidFile>& files) {
  Expression whole = 0;
  for (Index i = 1; i < files.size(); ++i) whole = operation_of(files[i].operation, whole, i);
  return whole;
}

// Names the file instead of the number of the operand.
std::string message_of(const Error& error, const std::vector<SolidFile>& files) {
  const std::string message = error.what();
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string number = fmt::format("operand {}: ", i);
    if (message.rfind(number, 0) == 0) {
      return files[i].path + ": " + message.substr(number.size());
    }
  }
  return message;
}

}  // namespace

std::vector<SolidFile> solid_files(const Command& command) {
  std::vector<SolidFile> files(1);
  bool transformed = false;
  for (const RepeatedArgument& argument : command.solids) {
    if (argument.flag == "--transform") {
      if (transformed) refuse(argument, "is given twice for one operand");
      transformed = true;
      files.back().transform = transform_of(argument);
      continue;
    }
    if (argument.value == kStandardStream) refuse(argument, "it cannot be read from a stream");
    transformed = false;
    files.push_back({argument.value, Transform::Identity(), argument.flag});
  }
  return files;
}

MadeManifold make_solids(const Command& command, const std::string& input_name, const Mesh& input,
                         const StepProgress& progress, RunReport& report) {
  std::vector<SolidFile> files = solid_files(command);
  files[0].path = input_name;
  std::vector<Mesh> meshes(files.size());
  std::vector<Operand> operands;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (i > 0) {
      const FileFormat format = input_format(files[i].path, FileFormat::kByName);
      ReadMesh read = read_mesh_file(files[i].path, format);
      meshes[i] = std::move(read.mesh);
      report.warnings.insert(report.warnings.end(), read.warnings.begin(), read.warnings.end());
    }
    operands.emplace_back(i > 0 ? meshes[i] : input, files[i].transform);
  }
  try {
    return make_solids_in_steps(joined(files), operands,
                                {command.build, command.extract, command.reduction}, progress);
  } catch (const Error& error) {
    throw Error(error.code(), message_of(error, files));
  }
}

Grid merge_grids_of(const Command& command, const std::string& input, const Progress& progress) {
  Grid merged = read_grid_file(input);
  std::vector<Grid> others;
  for (const RepeatedArgument& argument : command.solids) {
    others.push_back(read_grid_file(argument.value));
  }
  const double count = static_cast<double>(others.size());
  for (std::size_t i = 0; i < others.size(); ++i) {
    const RepeatedArgument& argument = command.solids[i];
    Progress part;
    if (progress) {
      part = [&, i](double fraction, std::string_view phase) {
        return progress((static_cast<double>(i) + fraction) / count, phase);
      };
    }
    try {
      merged = merge_grids(merged, others[i], operation_of(argument.flag, 0, 1), part);
    } catch (const Error& error) {
      throw Error(error.code(), argument.value + ": " + error.what());
    }
  }
  return merged;
}

}  // namespace kdm::cli
