// SPDX-License-Identifier: MIT
// Reads the arguments by the tables of options. cli-options.ts does the same, word for word.
#include "cli/options.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "cli/describe.h"
#include "cli/help.h"
#include "cli/solids.h"
#include "cli/suggest.h"

namespace kdm::cli {
namespace {

bool is_whole(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

template <typename Choice>
std::vector<std::string> word_list() {
  std::vector<std::string> list;
  for (const Word<Choice>& word : words_of<Choice>()) list.emplace_back(word.word);
  return list;
}

// Reads whole numbers of which each is smaller than the one before. Greater ones than indices count
// as the greatest. Returns what is wrong, or "".
std::string read_list(const OptionField& field, const std::string& text,
                      std::vector<Index>& target) {
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const std::string part = text.substr(at, end - at);
    const double number = is_whole(part) ? to_number(part) : std::nan("");
    if (!contains(field.range, number)) {
      return fmt::format("'{}' is no whole number {}", part, range_text(field.range));
    }
    const auto index = static_cast<Index>(std::min<double>(number, kNone));
    if (!target.empty() && index >= target.back()) {
      return fmt::format("'{}' must be smaller than the number before", part);
    }
    target.push_back(index);
    at = end + 1;
  }
  return "";
}

// Reads the lowest and the highest corner of a box. Returns what is wrong, or "".
std::string read_box(const std::string& text, std::optional<BoxCorners>& target) {
  const std::vector<double> numbers = to_numbers(text);
  BoxCorners box{};
  if (numbers.size() == box.size()) std::copy(numbers.begin(), numbers.end(), box.begin());
  if (!is_box(box)) {
    return fmt::format(
        "'{}' is no box: 6 numbers with commas between them, the lowest corner before the highest",
        text);
  }
  target = box;
  return "";
}

// Takes the value over. Returns what is wrong with it, or "".
template <typename Value>
std::string read_value(const OptionField& field, const std::string& text, Value& target) {
  if constexpr (std::is_same_v<Value, std::string>) {
    if (text.empty()) return "the value is empty";
    target = text;
  } else if constexpr (std::is_enum_v<Value>) {
    const std::optional<Value> value = value_of<Value>(text);
    if (!value) {
      return fmt::format("'{}' is none of {}{}", text, joined_words<Value>(", "),
                         did_you_mean(text, word_list<Value>()));
    }
    target = *value;
  } else if constexpr (std::is_same_v<Value, std::vector<Index>>) {
    return read_list(field, text, target);
  } else if constexpr (std::is_same_v<Value, std::optional<BoxCorners>>) {
    return read_box(text, target);
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

// What can be typed. Flags have no `read`, values no `set`, what may be repeated neither.
struct Entry {
  std::string flag;
  std::string short_flag;
  std::function<void()> set;
  std::function<std::string(const std::string&)> read;
  bool repeats = false;
};

template <typename Options>
void add_entries(std::vector<Entry>& entries, Options& options) {
  for_each_field(options, [&](const OptionField& field, auto& target) {
    using Value = std::decay_t<decltype(target)>;
    Entry entry{flag_of(field, target), {}, {}, {}};
    if (field.short_name[0] != '\0') entry.short_flag = std::string("-") + field.short_name;
    if constexpr (std::is_same_v<Value, Repeated>) {
      entry.repeats = true;
    } else if constexpr (std::is_same_v<Value, bool>) {
      entry.set = [&target, standard = target] { target = !standard; };
    } else if constexpr (std::is_same_v<Value, std::optional<bool>>) {
      entry.set = [&target] { target = false; };
    } else {
      entry.read = [field, &target](const std::string& text) {
        return read_value(field, text, target);
      };
    }
    entries.push_back(std::move(entry));
  });
}

// `--splitError` -> `--split-error`.
std::string dashed(const std::string& name) {
  std::string text;
  for (const char c : name) {
    const bool capital = c >= 'A' && c <= 'Z';
    if (capital) text += '-';
    text += capital ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return text;
}

constexpr const char* kSeeHelp = " (--help lists the options)";

[[noreturn]] void refuse_unknown(const std::string& name, const std::vector<Entry>& entries) {
  std::vector<std::string> flags = {"help", "version"};
  for (const Entry& entry : entries) flags.push_back(entry.flag.substr(2));
  const std::string word = dashed(name.substr(std::min(name.size(), name.find_first_not_of('-'))));
  std::string near = nearest(word, flags);
  if (!near.empty()) {
    near = "--" + near;
  } else if (name[1] != '-') {  // the value may stand right behind the letter
    for (const Entry& entry : entries) {
      const std::string& flag = entry.short_flag;
      if (!flag.empty() && name.rfind(flag, 0) == 0) near = flag + ' ' + name.substr(flag.size());
    }
  }
  throw UsageError(fmt::format("{}: there is no such option{}", name,
                               near.empty() ? kSeeHelp : "; did you mean " + near + "?"));
}

// Goes through the arguments one by one.
class Scanner {
 public:
  Scanner(const std::vector<std::string>& arguments, Command& command)
      : arguments_(arguments), command_(command) {
    add_entries(entries_, command.files);
    add_entries(entries_, command.report);
    add_entries(entries_, solids_);
    add_entries(entries_, command.build);
    add_entries(entries_, command.extract);
    add_entries(entries_, command.reduction);
    entries_.push_back(
        {"--no-strict", "", [&command] { command.extract.strict = Strict::kOff; }, {}});
  }

  void run() {
    while (at_ < arguments_.size()) {
      const std::string& argument = arguments_[at_++];
      if (argument == "--") {
        command_.inputs.insert(command_.inputs.end(),
                               arguments_.begin() + static_cast<std::ptrdiff_t>(at_),
                               arguments_.end());
        return;
      }
      if (argument.size() > 1 && argument[0] == '-') {
        read_option(argument);
      } else {
        command_.inputs.push_back(argument);
      }
    }
  }

 private:
  void read_option(const std::string& argument) {
    const std::size_t equals = argument.find('=');
    const bool has_value = equals != std::string::npos;
    const std::string name = argument.substr(0, equals);
    const Entry& entry = find(name);
    const bool first = command_.typed.emplace(entry.flag, name).second;
    if (entry.set) {
      if (has_value) throw UsageError(name + ": takes no value");
      if (first) entry.set();
      return;
    }
    if (!first && !entry.repeats) throw UsageError(name + ": is given twice");
    const std::string value = has_value ? argument.substr(equals + 1) : next_value(name);
    if (entry.repeats) {
      if (value.empty()) throw UsageError(name + ": the value is empty");
      command_.solids.push_back({entry.flag, name, value});
      return;
    }
    const std::string wrong = entry.read(value);
    if (!wrong.empty()) throw UsageError(name + ": " + wrong);
  }

  const Entry& find(const std::string& name) const {
    const std::string flag = name[1] == '-' ? dashed(name) : name;
    for (const Entry& entry : entries_) {
      if (entry.flag == flag || entry.short_flag == flag) return entry;
    }
    refuse_unknown(name, entries_);
  }

  // What looks like an option is none's value: that one was forgotten.
  const std::string& next_value(const std::string& name) {
    if (at_ == arguments_.size() || arguments_[at_].rfind("--", 0) == 0) {
      throw UsageError(name + ": the value is missing");
    }
    return arguments_[at_++];
  }

  const std::vector<std::string>& arguments_;
  Command& command_;
  SolidOptions solids_;
  std::vector<Entry> entries_;
  std::size_t at_ = 0;
};

// Whatever else is wrong: who asks for help gets it.
std::string answer_to(const std::vector<std::string>& arguments) {
  const auto end = std::find(arguments.begin(), arguments.end(), "--");
  const auto given = [&](const char* flag) {
    return std::find(arguments.begin(), end, flag) != end;
  };
  if (given("--help") || given("-h")) return help_text();
  if (given("--version")) return "kdmanifold " KDM_VERSION "\n";
  if (given("--describe")) return description();  // for scripts, so not in the help
  return "";
}

// Refuses options of building, extracting and reducing that have no effect or exclude each other.
void check_effects(const Command& command) {
  const auto given = [&](std::string_view name) {
    return command.typed.contains("--" + kebab_case(name));
  };
  try {
    check_combination(command.build, given);
    check_combination(command.extract, given);
    check_combination(command.reduction, given);
    reduces({command.build, command.extract, command.reduction});
  } catch (const Error& error) {
    throw UsageError(with_typed_names(command, error.what()));
  }
}

// What the values alone cannot tell.
void check_combination(const Command& command) {
  const FileOptions& files = command.files;
  const auto refuse = [&](const char* flag, const std::string& text) {
    throw UsageError(as_typed(command, flag) + ": " + text);
  };
  if (command.inputs.empty()) throw UsageError(std::string("INPUT is required") + kSeeHelp);
  for (const std::string& input : command.inputs) {
    if (input.empty()) throw UsageError(std::string("INPUT is empty") + kSeeHelp);
  }
  if (!files.save_grid.empty() && !names_a_grid(files.save_grid)) {
    refuse("--save-grid", fmt::format("'{}' does not end in .kdgrid", files.save_grid));
  }
  if (!files.out_dir.empty() && !files.output.empty()) {
    refuse("--out-dir", "not together with " + as_typed(command, "--output"));
  }
  if (!files.out_dir.empty() && !files.save_grid.empty()) {
    refuse("--out-dir", "not together with " + as_typed(command, "--save-grid"));
  }
  solid_files(command);
  if (command.typed.contains("--no-strict") && command.typed.contains("--strict")) {
    refuse("--no-strict", "not together with " + as_typed(command, "--strict"));
  }
  if (files.format != FileFormat::kByName && files.output.empty() && files.out_dir.empty()) {
    refuse("--format", "only with -o or --out-dir");
  }
  const std::vector<Index>& levels = command.reduction.target_triangles;
  if (!levels.empty() && command.reduction.reduce.has_value()) {
    refuse("--target-triangles", "not together with " + as_typed(command, "--no-reduce"));
  }
  check_effects(command);
  if (levels.size() > 1 && files.output == kStandardStream) {
    refuse("--target-triangles", "standard output takes one level, not several");
  }
  if (command.report.quiet && command.report.json) {
    refuse("--quiet", "not together with --json, which prints a report");
  }
}

}  // namespace

std::string with_typed_names(const Command& command, const std::string& text) {
  std::string result;
  std::size_t done = 0;
  for (std::size_t at = text.find('`'); at != std::string::npos; at = text.find('`', done)) {
    const std::size_t end = text.find('`', at + 1);
    if (end == std::string::npos) break;
    const std::string name = "--" + kebab_case(text.substr(at + 1, end - at - 1));
    result += text.substr(done, at - done) + as_typed(command, name);
    done = end + 1;
  }
  return result + text.substr(done);
}

std::vector<double> to_numbers(const std::string& text) {
  std::vector<double> numbers;
  std::size_t begin = 0;
  for (std::size_t end = 0; end != std::string::npos; begin = end + 1) {
    end = text.find(',', begin);
    numbers.push_back(to_number(text.substr(begin, end - begin)));
  }
  return numbers;
}

double to_number(const std::string& text) {
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = fast_float::from_chars(text.data(), end, number);
  const bool read = error == std::errc() && rest == end && std::isfinite(number);
  return read ? number : std::nan("");
}

Command parse_command(const std::vector<std::string>& arguments) {
  Command command;
  command.answer = answer_to(arguments);
  if (!command.answer.empty()) return command;
  Scanner(arguments, command).run();
  check_combination(command);
  return command;
}

}  // namespace kdm::cli
