// SPDX-License-Identifier: MIT
// The table of options and its reading by CLI11.
#include "cli/options.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <vector>

namespace kdm::cli {
namespace {

template <typename Value>
struct Word {
  const char* word;
  Value value;
};

constexpr Word<Strict> kStrict[] = {
    {"off", Strict::kOff}, {"manifold", Strict::kManifold}, {"embedded", Strict::kEmbedded}};
constexpr Word<SplitStrategy> kStrategies[] = {{"adaptive", SplitStrategy::kAdaptive},
                                               {"octree", SplitStrategy::kOctree},
                                               {"feature", SplitStrategy::kFeature},
                                               {"median", SplitStrategy::kMedian},
                                               {"uniform", SplitStrategy::kUniform}};
constexpr Word<InsideRule> kInsideRules[] = {{"repair", InsideRule::kRepair},
                                             {"positive", InsideRule::kPositive},
                                             {"odd", InsideRule::kOdd},
                                             {"nonzero", InsideRule::kNonzero},
                                             {"sheet", InsideRule::kSheet}};
constexpr Word<Pairing> kPairings[] = {{"trace", Pairing::kTrace},
                                       {"hermite", Pairing::kHermite},
                                       {"inside", Pairing::kInside},
                                       {"outside", Pairing::kOutside}};

constexpr Word<Parts> kParts[] = {
    {"all", Parts::kAll}, {"outer", Parts::kOuter}, {"largest", Parts::kLargest}};

constexpr Word<VertexPosition> kPositions[] = {{"constrained", VertexPosition::kConstrained},
                                               {"projection", VertexPosition::kProjection}};

template <typename Value, std::size_t kCount>
const char* find_word(const Word<Value> (&words)[kCount], Value value) {
  for (const Word<Value>& word : words) {
    if (word.value == value) return word.word;
  }
  return "?";
}

template <typename Value, std::size_t kCount>
std::string joined(const Word<Value> (&words)[kCount], const char* separator) {
  std::string text;
  for (const Word<Value>& word : words) {
    if (!text.empty()) text += separator;
    text += word.word;
  }
  return text;
}

// An option with a value: its setter returns what is wrong with the value, or "".
struct ValueOption {
  const char* name;
  std::string value;  // as help shows it
  std::string help;
  std::function<std::string(const std::string&)> set;
};

struct Flag {
  const char* name;
  std::string help;
  std::function<void()> set;
};

template <typename Value, std::size_t kCount>
ValueOption choice(const char* name, const Word<Value> (&words)[kCount], Value& target,
                   const char* help) {
  return {name, joined(words, "|"), fmt::format("{} ({})", help, find_word(words, target)),
          [name, &words, &target](const std::string& text) -> std::string {
            for (const Word<Value>& word : words) {
              if (word.word != text) continue;
              target = word.value;
              return "";
            }
            return fmt::format("{}: '{}' is none of {}", name, text, joined(words, ", "));
          }};
}

ValueOption whole_number(const char* name, int low, int high, int& target, const char* help) {
  return {name, "N", fmt::format("{}, {} to {}", help, low, high),
          [=, &target](const std::string& text) -> std::string {
            int number = 0;
            const bool digits = !text.empty() && text.size() < 9 &&
                                text.find_first_not_of("0123456789") == std::string::npos;
            if (digits) number = std::stoi(text);
            if (!digits || number < low || number > high) {
              return fmt::format("{}: '{}' is no whole number from {} to {}", name, text, low,
                                 high);
            }
            target = number;
            return "";
          }};
}

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

ValueOption not_negative(const char* name, const char* letter, double& target, const char* help,
                         double most = kNoLimit) {
  return {name, letter, help, [=, &target](const std::string& text) -> std::string {
            double number = 0;
            const char* const end = text.data() + text.size();
            const auto [rest, error] = fast_float::from_chars(text.data(), end, number);
            if (error != std::errc() || rest != end || !std::isfinite(number) || number < 0 ||
                number > most) {
              return fmt::format("{}: '{}' is no number from 0 {}", name, text,
                                 most < kNoLimit ? fmt::format("to {}", most) : "on");
            }
            target = number;
            return "";
          }};
}

// What has no effect on a grid that is loaded.
std::vector<ValueOption> build_options(Command& command) {
  return {
      choice("--strategy", kStrategies, command.build.strategy, "how cells are split"),
      not_negative("--tolerance", "T", command.build.tolerance,
                   "distance from the input in model units; 0: the relative one counts (0)"),
      not_negative("--relative-tolerance", "R", command.build.relative_tolerance,
                   "the same as a fraction of the bounding box's diagonal (0.001)"),
      whole_number("--depth", 1, 60, command.build.depth, "limit of the tree's depth"),
      choice("--inside", kInsideRules, command.build.inside,
             "which winding numbers are inside; sheet: none, open surfaces stay open"),
      not_negative(
          "--winding-threshold", "W", command.build.winding_threshold,
          "repair: winding numbers above this are inside, below 1; 0: what keeps most faces (0)",
          1),
      not_negative("--largest-hole", "W", command.build.largest_hole,
                   "repair: wider holes are refused, in model units; 0: all are closed (0)"),
      choice("--pairing", kPairings, command.build.pairing,
             "how hits are linked where a face has more than two"),
      not_negative("--thicken", "T", command.build.thicken,
                   "build a shell of this thickness around the surface, in model units; 0: the "
                   "input itself (0)"),
  };
}

std::vector<ValueOption> extract_options(Command& command) {
  return {
      choice("--parts", kParts, command.extract.parts,
             "which parts are kept; outer: no cavities, nothing within others"),
      choice("--strict", kStrict, command.extract.strict,
             "what the index mesh must be; embedded: nothing crosses, 32-bit coordinates"),
      not_negative("--link-error", "E", command.extract.link_error,
                   "vertices where edges pass between leaves further than E from the surface, in "
                   "model units; 0: the tolerance (0)"),
      not_negative("--split-error", "E", command.extract.split_error,
                   "split vertices further than E from a plane, in model units; 0: features (0)"),
      choice("--position", kPositions, command.extract.position,
             "how vertices are kept within their cells"),
      not_negative("--crease-angle", "A", command.extract.crease_angle,
                   "normals differ where faces turn by more, 0 to 180 degrees (30)", 180),
  };
}

std::vector<Flag> flags(Command& command) {
  return {
      {"--quads", "write quads where four leaves meet", [&] { command.extract.quads = true; }},
      {"--no-unfold", "leave triangles that are folded over or thin as they are",
       [&] { command.extract.unfold = false; }},
      {"--no-strict", "keep double edges and parts without volume, as --strict off",
       [&] { command.extract.strict = Strict::kOff; }},
      {"--normals", "write normals at the corners of faces (OBJ)",
       [&] { command.extract.normals = true; }},
      {"--json", "print one JSON report on standard output, nothing else",
       [&] { command.json = true; }},
      {"--check", "verify the output, count crossings; exit status 1 if it is not 2-manifold",
       [&] { command.check = true; }},
      {"--stats", "describe the input's defects; alone, nothing else is done",
       [&] { command.stats = true; }},
  };
}

std::string one_line(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return text;
}

}  // namespace

const char* word_of(SplitStrategy strategy) { return find_word(kStrategies, strategy); }
const char* word_of(InsideRule rule) { return find_word(kInsideRules, rule); }
const char* word_of(Pairing pairing) { return find_word(kPairings, pairing); }

Command parse_command(int argc, const char* const* argv) {
  Command command;
  CLI::App app(
      "Makes a closed, oriented 2-manifold mesh of any mesh.\n"
      "Formats by extension: OBJ, STL, PLY, OFF; saved grids: .kdgrid.\n",
      "kdmanifold");
  app.add_option("INPUT", command.input, "the mesh to convert, or a saved grid")
      ->required()
      ->type_name("");
  app.add_option("-o,--output", command.output, "where the result goes")->type_name("FILE");
  app.add_option("--save-grid", command.save_grid,
                 "where the grid goes, to be INPUT another time (.kdgrid)")
      ->type_name("FILE");
  // Not by CLI11's validators, which wrap messages of their own around ours.
  std::string fault;
  // The lists must live until the arguments have been read.
  const std::vector<ValueOption> of_build = build_options(command);
  const std::vector<ValueOption> of_extract = extract_options(command);
  for (const std::vector<ValueOption>* options : {&of_build, &of_extract}) {
    for (const ValueOption& option : *options) {
      app.add_option_function<std::string>(
             option.name,
             [&](const std::string& text) {
               if (fault.empty()) fault = option.set(text);
             },
             option.help)
          ->type_name(option.value);
    }
  }
  for (const Flag& flag : flags(command)) app.add_flag_callback(flag.name, flag.set, flag.help);
  app.set_version_flag("--version", "kdmanifold " KDM_VERSION, "print the version");
  app.footer(
      "Exit status: 0 done, 1 --check found the output not 2-manifold, 2 bad input or option.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    command.answer = app.help();
    return command;
  } catch (const CLI::CallForVersion& version) {
    command.answer = std::string(version.what()) + "\n";
    return command;
  } catch (const CLI::ParseError& error) {
    throw UsageError(one_line(error.what()) + " (--help lists the options)");
  }
  if (!fault.empty()) throw UsageError(fault);
  if (!command.save_grid.empty() && !names_a_grid(command.save_grid)) {
    throw UsageError(fmt::format("--save-grid: '{}' does not end in .kdgrid", command.save_grid));
  }
  if (command.stats && names_a_grid(command.input)) {
    throw UsageError(fmt::format("--stats: {} is a grid, which has no faces", command.input));
  }
  for (const ValueOption& option : of_build) {
    if (names_a_grid(command.input) && app.count(option.name) > 0) {
      throw UsageError(
          fmt::format("{}: the grid in {} is built already", option.name, command.input));
    }
  }
  return command;
}

}  // namespace kdm::cli
