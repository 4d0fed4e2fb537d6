// SPDX-License-Identifier: MIT
// Makes the help of the tables of options.
#include "cli/help.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "cli/command.h"

namespace kdm::cli {
namespace {

constexpr std::size_t kLeftColumn = 28;  // most options with their letter fit
constexpr std::size_t kWidth = 100;      // where lines are broken

struct Line {
  std::string option;  // as it is typed, with what stands for its value
  std::string help;
  std::vector<std::string> words = {};  // of a choice, each with its meaning
};

// Help is plain text: the quotation marks round names go.
std::string plain(std::string text) {
  std::erase(text, '`');
  return text;
}

// The range and the default of a number as they stand in parentheses behind its help.
template <typename Value>
std::string number_notes(const OptionField& field, Value standard) {
  std::vector<std::string> notes;
  const std::string unit = unit_name(field.unit);
  const std::string range = has_end(field.range) ? range_text(field.range) : "";
  if (!(unit + range).empty()) {
    notes.push_back(unit + (unit.empty() || range.empty() ? "" : " ") + range);
  }
  const bool unset = field.unset[0] != '\0';
  const bool has_zero = field.zero[0] != '\0';
  if (unset) {
    notes.push_back(fmt::format("default {}", field.unset));
  } else if (has_zero && standard == 0) {
    notes.push_back(fmt::format("0, the default: {}", field.zero));
  } else {
    notes.push_back(fmt::format("default {}", standard));
    if (has_zero) notes.push_back(fmt::format("0: {}", field.zero));
  }
  return fmt::format(" ({})", fmt::join(notes, "; "));
}

template <typename Value>
Line line_of(const OptionField& field, const Value& standard) {
  std::string option = flag_of(field, standard);
  if (field.short_name[0] != '\0') option = fmt::format("-{}, {}", field.short_name, option);
  if constexpr (std::is_same_v<Value, bool>) {
    return {option, (standard ? "do not " : "") + std::string(field.help)};
  } else if constexpr (std::is_same_v<Value, std::optional<bool>>) {
    return {option, "do not " + std::string(field.help)};
  } else if constexpr (std::is_same_v<Value, std::vector<Index>>) {
    return {option + ' ' + field.letter, fmt::format("{} (default {})", field.help, field.unset)};
  } else if constexpr (std::is_same_v<Value, std::optional<BoxCorners>>) {
    return {option + ' ' + field.letter,
            fmt::format("{} ({}; default {})", field.help, unit_name(field.unit), field.unset)};
  } else if constexpr (std::is_enum_v<Value>) {
    const bool unset = field.unset[0] != '\0';
    Line line{option + ' ' + joined_words<Value>("|"),
              fmt::format("{} (default {})", field.help, unset ? field.unset : word_of(standard))};
    if (unset) return line;  // words that need no explanation
    for (const Word<Value>& word : words_of<Value>()) {
      line.words.push_back(fmt::format("{}: {}", word.word, plain(word.help)));
    }
    return line;
  } else if constexpr (std::is_arithmetic_v<Value>) {
    return {option + ' ' + field.letter, field.help + number_notes(field, standard)};
  } else {
    return {option + ' ' + field.letter, field.help};
  }
}

template <typename Options>
void add_lines(std::vector<Line>& lines) {
  const Options standard;
  for_each_field(standard, [&](const OptionField& field, const auto& value) {
    lines.push_back(line_of(field, value));
    lines.back().help = plain(lines.back().help);
  });
}

// Breaks the text between words; every line of it but the first is indented by `indent`.
std::string broken(const std::string& text, std::size_t indent) {
  std::string lines;
  std::size_t column = indent;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    if (at > 0) {
      const bool fits = column + 1 + end - at <= kWidth;
      lines += fits ? " " : '\n' + std::string(indent, ' ');
      column = fits ? column + 1 : indent;
    }
    lines.append(text, at, end - at);
    column += end - at;
    at = end + 1;
  }
  return lines + '\n';
}

// The option stands in the left column, its help in the right one, on the next line if need be; the
// words of a choice stand a little further right.
std::string written(const Line& line) {
  std::string text = "  " + line.option;
  const bool fits = text.size() + 2 <= kLeftColumn;
  text += fits ? std::string(kLeftColumn - text.size(), ' ') : '\n' + std::string(kLeftColumn, ' ');
  text += broken(line.help, kLeftColumn);
  for (const std::string& word : line.words) {
    text += std::string(kLeftColumn + 2, ' ') + broken(word, kLeftColumn + 4);
  }
  return text;
}

}  // namespace

std::string help_text() {
  std::string text =
      "Makes a closed, oriented 2-manifold mesh of any mesh.\n"
      "Formats by extension: OBJ, STL, PLY, OFF, GLB; saved grids: .kdgrid.\n"
      "\n"
      "Usage: kdmanifold [OPTIONS] INPUT...\n"
      "\n"
      "INPUT is a mesh to convert, a saved grid, a pattern such as 'parts/**/*.stl', or - for\n"
      "standard input. Names that begin with - follow --. Options may be in camel case too.\n";
  const auto add_group = [&](const char* title, const std::vector<Line>& lines) {
    text += fmt::format("\n{}:\n", title);
    for (const Line& line : lines) text += written(line);
  };
  std::vector<Line> lines;
  add_lines<FileOptions>(lines);
  add_group("Files", lines);
  lines.clear();
  add_lines<ReportOptions>(lines);
  lines.push_back({"--version", "print the version"});
  lines.push_back({"-h, --help", "print this"});
  add_group("Checks and reports", lines);
  lines.clear();
  add_lines<SolidOptions>(lines);
  add_group("Boolean operations", lines);
  lines.clear();
  add_lines<BuildOptions>(lines);
  add_group("How a mesh becomes a grid", lines);
  lines.clear();
  add_lines<ExtractOptions>(lines);
  lines.push_back({"--no-strict", "keep double edges and parts without volume, as --strict off"});
  add_group("How a grid becomes a mesh", lines);
  lines.clear();
  add_lines<ReductionOptions>(lines);
  add_group("How a mesh gets fewer triangles", lines);
  return text +
         "\n"
         "Exit status: 0 done, 1 --check found an output not 2-manifold (of a sheet: not a\n"
         "manifold with boundary), 2 bad input or option. Of several inputs the bad ones are\n"
         "named, and the others are done.\n";
}

}  // namespace kdm::cli
