// SPDX-License-Identifier: MIT
// What the command line asks for, and the table of the options that only the command lines have.
#pragma once

#include <string>

#include "kdmanifold/kdmanifold.h"
#include "kdmanifold/options.h"

namespace kdm::cli {

/// One run of the program, as its arguments say.
struct Command {
  std::string input;      ///< path of a mesh or of a saved grid
  std::string output;     ///< path of the result; empty: none is written
  std::string save_grid;  ///< path where the grid goes; empty: nowhere
  BuildOptions build;
  ExtractOptions extract;
  bool json = false;   ///< print the report as JSON
  bool check = false;  ///< verify the output; exit status 1 if it is not 2-manifold
  bool stats = false;  ///< describe the input's defects
  std::string answer;  ///< not empty: print this instead of working (--help, --version)
};

/// Says whether a grid is to be made. With --stats alone none is.
inline bool converts(const Command& command) {
  return !command.stats || command.check || !command.output.empty() || !command.save_grid.empty();
}

/// Calls `visit(const OptionField&, member)` for the options of the command lines themselves.
template <Either<Command> Options, typename Visit>
void for_each_field(Options& command, Visit&& visit) {
  visit(OptionField{.name = "output",
                    .short_name = "o",
                    .letter = "FILE",
                    .help = "where the result goes (.obj, .stl, .ply, .off)"},
        command.output);
  visit(OptionField{.name = "save_grid",
                    .letter = "FILE",
                    .help = "where the grid goes, to be INPUT another time (.kdgrid)"},
        command.save_grid);
  visit(
      OptionField{.name = "json", .help = "print one JSON report on standard output, nothing else"},
      command.json);
  visit(OptionField{.name = "check",
                    .help = "verify the output and count triangles that cross; exit status 1 if it "
                            "is not 2-manifold"},
        command.check);
  visit(OptionField{.name = "stats",
                    .help = "describe the input's defects; alone, nothing else is done"},
        command.stats);
}

/// Writes the option as it is typed: `--split-error`; `--no-unfold` for flags that are on already.
template <typename Value>
std::string flag_of(const OptionField& field, const Value& standard) {
  bool on = false;
  if constexpr (std::is_same_v<Value, bool>) on = standard;
  return (on ? "--no-" : "--") + kebab_case(field.name);
}

}  // namespace kdm::cli
