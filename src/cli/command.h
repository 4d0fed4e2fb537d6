// SPDX-License-Identifier: MIT
// What the command line asks for, and the tables of the options that only the command lines have.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/file_format.h"
#include "kdmanifold/kdmanifold.h"
#include "kdmanifold/options.h"

namespace kdm::cli {

/// Where results go, and what files are.
struct FileOptions {
  std::string output;                             ///< path of the result; empty: none is written
  std::string out_dir;                            ///< folder of the results; empty: there is none
  FileFormat format = FileFormat::kByName;        ///< of results
  FileFormat input_format = FileFormat::kByName;  ///< of inputs
  std::string save_grid;                          ///< path where the grid goes; empty: nowhere
  bool force = false;                             ///< overwrite files that exist
};

/// What is looked at and said, and by how many threads.
struct ReportOptions {
  bool check = false;  ///< verify the output; exit status 1 if it is not 2-manifold
  bool stats = false;  ///< describe the input's defects
  bool json = false;   ///< print the report as JSON
  bool quiet = false;  ///< print nothing but errors
  int threads = 0;     ///< that share the work; 0: as many as the machine runs at once
};

/// Stands for an option that may be given several times: what was given is kept in the order of the
/// command line, among that of the others like it.
struct Repeated {};

/// The operands of a Boolean operation beside INPUT, from left to right, and where they go.
struct SolidOptions {
  Repeated united, intersected, subtracted, exclusive, transform;
};

/// One of these options, as it was given.
struct RepeatedArgument {
  std::string flag;
  std::string typed;  ///< the flag as the user has typed it
  std::string value;
};

/// One run of the program, as its arguments say.
struct Command {
  std::vector<std::string> inputs;  ///< paths of meshes or of saved grids, `-`, and patterns
  FileOptions files;
  ReportOptions report;
  BuildOptions build;
  ExtractOptions extract;
  ReductionOptions reduction;
  std::vector<RepeatedArgument> solids;
  std::map<std::string, std::string> typed;  ///< options that are given: how, by their flags
  std::string answer;  ///< not empty: print this instead of working (--help, --version)
};

/// Says whether INPUT is an operand of a Boolean operation.
inline bool joins_solids(const Command& command) { return !command.solids.empty(); }

/// Says whether something is to be written.
inline bool writes(const FileOptions& files) {
  return !files.output.empty() || !files.out_dir.empty() || !files.save_grid.empty();
}

/// Says whether a grid is to be made. With --stats alone none is.
inline bool converts(const Command& command) {
  return !command.report.stats || command.report.check || writes(command.files);
}

/// Calls `visit(const OptionField&, member)` for the options of the command lines themselves.
template <Either<FileOptions> Options, typename Visit>
void for_each_field(Options& files, Visit&& visit) {
  visit(OptionField{.name = "output",
                    .short_name = "o",
                    .letter = "FILE",
                    .help = "where the result goes, of one input; - is standard output"},
        files.output);
  visit(
      OptionField{.name = "out_dir",
                  .letter = "DIR",
                  .help = "where results go, named after their inputs; made if its parent exists"},
      files.out_dir);
  visit(OptionField{.name = "format",
                    .help = "what results are, whatever their names say",
                    .unset = "by extension"},
        files.format);
  visit(OptionField{.name = "input_format",
                    .help = "what inputs are, whatever their names say",
                    .unset = "by extension"},
        files.input_format);
  visit(OptionField{.name = "save_grid",
                    .letter = "FILE",
                    .help = "where the grid goes, to be INPUT another time (.kdgrid)"},
        files.save_grid);
  visit(OptionField{.name = "force", .help = "overwrite files that exist"}, files.force);
}

/// See above.
template <Either<ReportOptions> Options, typename Visit>
void for_each_field(Options& report, Visit&& visit) {
  visit(OptionField{.name = "check",
                    .help = "verify the output, count triangles that cross and measure how far it "
                            "is from the input; exit status 1 if it is not 2-manifold"},
        report.check);
  visit(OptionField{.name = "stats",
                    .help = "describe the input's defects; alone, nothing else is done"},
        report.stats);
  visit(OptionField{.name = "json",
                    .help = "print one JSON report on standard output, nothing else; of several "
                            "inputs, a list of reports"},
        report.json);
  visit(OptionField{.name = "quiet", .help = "print nothing but errors"}, report.quiet);
  visit(
      OptionField{.name = "threads",
                  .letter = "N",
                  .help = "how many threads share the work; results are the same with any number. "
                          "In Node the default is at most 16",
                  .range = {.least = 1, .most = kMostThreads},
                  .unset = "as many as the machine runs at once"},
      report.threads);
}

/// See above.
template <Either<SolidOptions> Options, typename Visit>
void for_each_field(Options& solids, Visit&& visit) {
  visit(
      OptionField{.name = "union",
                  .letter = "FILE",
                  .help = "join a mesh to INPUT and to what came of the options before; each of "
                          "these may be given several times, and they are done from left to "
                          "right. A grid as INPUT is merged with other grids that were built with "
                          "the same `box`"},
      solids.united);
  visit(
      OptionField{
          .name = "intersection", .letter = "FILE", .help = "keep what lies in this mesh too"},
      solids.intersected);
  visit(OptionField{.name = "difference", .letter = "FILE", .help = "cut this mesh off"},
        solids.subtracted);
  visit(OptionField{.name = "symmetric_difference",
                    .letter = "FILE",
                    .help = "keep what lies either in this mesh or in what was there, but not in "
                            "both"},
        solids.exclusive);
  visit(OptionField{.name = "transform",
                    .letter = "M",
                    .help = "where the mesh goes that was named last, at first INPUT: 12 numbers "
                            "with commas between them, the rows of a matrix of 3 by 4, or 16"},
        solids.transform);
}

/// Writes the option as it is typed: `--split-error`; `--no-unfold` for flags that are on already.
template <typename Value>
std::string flag_of(const OptionField& field, const Value& standard) {
  bool on = false;
  if constexpr (std::is_same_v<Value, bool>) on = standard;
  if constexpr (std::is_same_v<Value, std::optional<bool>>) on = true;
  return (on ? "--no-" : "--") + kebab_case(field.name);
}

/// Returns the flag as the user has typed it: `-o`, `--splitError`.
inline std::string as_typed(const Command& command, const std::string& flag) {
  const auto typed = command.typed.find(flag);
  return typed == command.typed.end() ? flag : typed->second;
}

/// Returns the text with the names of options in backticks as the user has typed them.
std::string with_typed_names(const Command& command, const std::string& text);

}  // namespace kdm::cli
