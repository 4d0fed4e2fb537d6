// SPDX-License-Identifier: MIT
// Turns arguments into tasks. cli-plan.ts does the same, word for word.
#include "cli/plan.h"

#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "cli/files.h"
#include "cli/glob.h"
#include "cli/options.h"

namespace kdm::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const Command& command, const char* flag, const std::string& text) {
  throw UsageError(as_typed(command, flag) + ": " + text);
}

// Every file once, in the order in which they come first. What exists is no pattern.
std::vector<std::string> expand_all(const std::vector<std::string>& inputs) {
  std::vector<std::string> paths;
  std::set<std::string> seen;
  const auto add = [&](const std::string& path) {
    if (seen.insert(path).second) paths.push_back(path);
  };
  for (const std::string& input : inputs) {
    std::error_code error;
    if (!is_pattern(input) || fs::exists(input, error)) {
      add(input);
      continue;
    }
    const std::vector<std::string> found = expand(input);
    if (found.empty()) throw UsageError(input + ": no file fits this pattern");
    for (const std::string& path : found) add(path);
  }
  return paths;
}

void check_number(const Command& command, std::size_t count) {
  if (count == 1) return;
  if (!command.files.output.empty()) {
    refuse(command, "--output",
           fmt::format("it takes the result of one input, but there are {}; --out-dir takes those "
                       "of several",
                       count));
  }
  if (!command.files.save_grid.empty()) {
    refuse(command, "--save-grid",
           fmt::format("it takes the grid of one input, but there are {}", count));
  }
}

void check_grid(const Command& command, const std::string& input) {
  if (command.report.stats) {
    refuse(command, "--stats", fmt::format("{} is a grid, which has no faces", input));
  }
  const auto check = [&](const OptionField& field, const auto& value) {
    const std::string flag = flag_of(field, value);
    if (command.typed.count(flag) > 0) {
      refuse(command, flag.c_str(), fmt::format("the grid in {} is built already", input));
    }
  };
  const BuildOptions build;
  for_each_field(build, check);
}

// Grids are merged with grids, meshes joined with meshes.
void check_operands(const Command& command, const Task& task) {
  for (const RepeatedArgument& argument : command.solids) {
    const auto refuse_operand = [&](const std::string& text) {
      throw UsageError(argument.typed + ": " + text);
    };
    if (argument.flag == "--transform") {
      if (task.is_grid) {
        refuse_operand(fmt::format("the grid in {} stays where it is", task.input));
      }
    } else if (task.is_grid != names_a_grid(argument.value)) {
      refuse_operand(
          task.is_grid ? fmt::format("{} is no grid, but {} is: grids are merged with grids",
                                     argument.value, task.input)
                       : fmt::format("{} is a grid, but {} is a mesh", argument.value, task.input));
    }
  }
}

// The path of the result in --out-dir.
std::string path_in(const Command& command, const Task& task) {
  const std::string& folder = command.files.out_dir;
  if (task.input == kStandardStream) {
    refuse(command, "--out-dir", "standard input has no name that its result could have");
  }
  std::string name(file_name(task.input));
  if (command.files.format != FileFormat::kByName) {
    const std::size_t dot = name.rfind('.');
    name = fmt::format("{}.{}", name.substr(0, dot == 0 ? name.npos : dot),
                       word_of(command.files.format));
  } else if (task.is_grid) {
    refuse(command, "--out-dir", fmt::format("what {} becomes is for --format to say", task.input));
  }
  return folder + (folder.back() == '/' ? "" : "/") + name;
}

void check_names(const Command& command, const std::vector<Task>& tasks) {
  std::map<std::string, std::string> inputs;  // by the names of their results
  for (const Task& task : tasks) {
    const auto first = inputs.emplace(task.output, task.input).first;
    if (first->second == task.input) continue;
    refuse(command, "--out-dir",
           fmt::format("{} and {} would both become {}", first->second, task.input, task.output));
  }
}

void check_out_dir(const Command& command) {
  const std::string& folder = command.files.out_dir;
  std::error_code error;
  std::string checked = folder;
  if (!fs::exists(folder, error)) {
    checked = fs::path(folder.substr(0, folder.find_last_not_of('/') + 1)).parent_path().string();
    if (checked.empty()) checked = ".";
  }
  check_folder(checked, as_typed(command, "--out-dir"));
}

}  // namespace

std::string level_path(const std::string& output, std::size_t level) {
  const std::size_t name = output.size() - file_name(output).size();
  const std::size_t dot = output.rfind('.');
  const std::size_t end = dot == output.npos || dot <= name ? output.size() : dot;
  return fmt::format("{}.{}{}", output.substr(0, end), level, output.substr(end));
}

std::vector<Task> plan(const Command& command) {
  const FileOptions& files = command.files;
  const std::vector<std::string> inputs = expand_all(command.inputs);
  check_number(command, inputs.size());
  std::vector<Task> tasks;
  for (const std::string& input : inputs) {
    Task task{input, files.output, false};
    task.is_grid = files.input_format == FileFormat::kByName && names_a_grid(input);
    if (task.is_grid) check_grid(command, input);
    check_operands(command, task);
    if (!files.out_dir.empty()) task.output = path_in(command, task);
    tasks.push_back(task);
  }
  if (!files.out_dir.empty()) {
    check_names(command, tasks);
    check_out_dir(command);
  }
  return tasks;
}

}  // namespace kdm::cli
