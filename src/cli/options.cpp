// SPDX-License-Identifier: MIT
// Reads the arguments with CLI11, by the tables of options.
#include "cli/options.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <vector>

#include "cli/describe.h"
#include "cli/help.h"

namespace kdm::cli {
namespace {

// Reads the whole text as a finite number; NaN if it is none.
double to_number(const std::string& text) {
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = fast_float::from_chars(text.data(), end, number);
  const bool read = error == std::errc() && rest == end && std::isfinite(number);
  return read ? number : std::nan("");
}

bool is_whole(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

// Takes the value over. Returns what is wrong with it, or "".
template <typename Value>
std::string read_value(const OptionField& field, const std::string& text, Value& target) {
  if constexpr (std::is_same_v<Value, std::string>) {
    target = text;
  } else if constexpr (std::is_enum_v<Value>) {
    const std::optional<Value> value = value_of<Value>(text);
    if (!value) return fmt::format("'{}' is none of {}", text, joined_words<Value>(", "));
    target = *value;
  } else {
    constexpr bool kWhole = std::is_integral_v<Value>;
    const double number = kWhole && !is_whole(text) ? std::nan("") : to_number(text);
    if (!contains(field.range, number)) {
      return fmt::format("'{}' is no {}number {}", text, kWhole ? "whole " : "",
                         range_text(field.range));
    }
    target = static_cast<Value>(number);
  }
  return "";
}

// Makes CLI11 fill the fields in. It looks no further than at names: its validators would wrap
// messages of their own around ours. The first thing that is wrong with a value is left in `fault`.
template <typename Options>
void add_fields(CLI::App& app, Options& options, std::string& fault) {
  for_each_field(options, [&](const OptionField& field, auto& target) {
    using Value = std::decay_t<decltype(target)>;
    const std::string flag = flag_of(field, target);
    if constexpr (std::is_same_v<Value, bool>) {
      app.add_flag_callback(flag, [&target, standard = target] { target = !standard; });
    } else {
      const std::string short_name = field.short_name;
      const std::string names = short_name.empty() ? flag : "-" + short_name + "," + flag;
      CLI::Option* const option = app.add_option_function<std::string>(
          names, [=, &target, &fault](const std::string& text) {
            const std::string wrong = read_value(field, text, target);
            if (fault.empty() && !wrong.empty()) fault = flag + ": " + wrong;
          });
      // Named where a value is missing.
      if constexpr (std::is_enum_v<Value>) {
        option->type_name(joined_words<Value>("|"));
      } else {
        option->type_name(field.letter);
      }
    }
  });
}

std::string one_line(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return text;
}

// What the values alone cannot tell.
void check_combination(const CLI::App& app, const Command& command) {
  if (!command.save_grid.empty() && !names_a_grid(command.save_grid)) {
    throw UsageError(fmt::format("--save-grid: '{}' does not end in .kdgrid", command.save_grid));
  }
  if (!names_a_grid(command.input)) return;
  if (command.stats) {
    throw UsageError(fmt::format("--stats: {} is a grid, which has no faces", command.input));
  }
  const BuildOptions standard;
  for_each_field(standard, [&](const OptionField& field, const auto& value) {
    const std::string flag = flag_of(field, value);
    if (app.count(flag) > 0) {
      throw UsageError(fmt::format("{}: the grid in {} is built already", flag, command.input));
    }
  });
}

}  // namespace

Command parse_command(int argc, const char* const* argv) {
  Command command;
  std::string fault;
  CLI::App app("", "kdmanifold");
  app.add_option("INPUT", command.input)->required();
  add_fields(app, command.build, fault);
  add_fields(app, command.extract, fault);
  add_fields(app, command, fault);
  app.add_flag_callback("--no-strict", [&] { command.extract.strict = Strict::kOff; });
  app.set_version_flag("--version", "kdmanifold " KDM_VERSION);
  // For scripts, so not in the help. Like --version it wants no INPUT.
  app.add_flag_callback("--describe", [] { throw CLI::Success(); });
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    command.answer = help_text();
    return command;
  } catch (const CLI::CallForVersion& version) {
    command.answer = std::string(version.what()) + "\n";
    return command;
  } catch (const CLI::Success&) {  // of --describe
    command.answer = description();
    return command;
  } catch (const CLI::ParseError& error) {
    throw UsageError(one_line(error.what()) + " (--help lists the options)");
  }
  if (!fault.empty()) throw UsageError(fault);
  check_combination(app, command);
  return command;
}

}  // namespace kdm::cli
