// SPDX-License-Identifier: MIT
// What describes one field of an options struct or of a report: its name, its legal values and its
// meaning in words. The descriptions themselves are in options.h and reports.h.
#pragma once

#include <limits>
#include <string>
#include <string_view>

namespace kdm {

/// What the numbers of a field count or measure.
enum class Unit {
  kPlain,        ///< plain counts, flags and words
  kModelUnits,   ///< lengths, in the unit of the input's coordinates
  kModelArea,    ///< areas, in that unit squared
  kModelVolume,  ///< volumes, in that unit cubed
  kDiagonals,    ///< lengths, as a fraction of the diagonal of the input's bounding box
  kDegrees,      ///< angles
  kBytes         ///< sizes in memory
};

/// Returns the unit as users read it after a number, e.g. "model units"; "" for `kPlain`.
constexpr const char* unit_name(Unit unit) {
  switch (unit) {
    case Unit::kModelUnits:
      return "model units";
    case Unit::kModelArea:
      return "square model units";
    case Unit::kModelVolume:
      return "cubic model units";
    case Unit::kDiagonals:
      return "diagonals of the bounding box";
    case Unit::kDegrees:
      return "degrees";
    case Unit::kBytes:
      return "bytes";
    case Unit::kPlain:
      break;
  }
  return "";
}

/// The legal values of a number.
struct Range {
  double least = 0;
  /// The largest finite number stands for "no limit, but finite", infinity for "no limit at all".
  double most = std::numeric_limits<double>::max();
  bool most_excluded = false;  ///< `most` itself is not legal any more
};

/// Says whether the value is legal. NaN never is.
constexpr bool contains(const Range& range, double value) {
  return value >= range.least && (range.most_excluded ? value < range.most : value <= range.most);
}

/// Says whether the range ends at a number, rather than where numbers end.
constexpr bool has_end(const Range& range) {
  return range.most < std::numeric_limits<double>::max();
}

/// Writes the range as it completes "a number ...": "from 0 on", "from 0 to 180".
std::string range_text(const Range& range);

/// One word of a choice. `help` completes "`word`: ...".
template <typename Value>
struct Word {
  const char* word;
  Value value;
  const char* help;
};
// Not every compiler finds this by itself.
template <typename Value>
Word(const char*, Value, const char*) -> Word<Value>;

/// One option. Its kind follows from the member's type: `bool` is a flag, `std::optional<bool>` a
/// flag that is on but where something excludes it, `int` a whole number, `double` a number,
/// `std::vector<Index>` whole numbers of which each is smaller than the one before,
/// `std::optional<BoxCorners>` a box, an enumeration a choice between `words_of` it, `std::string`
/// a text. Names of other options stand in backticks in the texts, as C++ writes them, and are to
/// be turned into the form that the reader knows (`camel_case`).
struct OptionField {
  const char* name;             ///< of the member, e.g. "split_error"
  const char* short_name = "";  ///< one letter that command lines take as well, e.g. "o"
  const char* letter = "";      ///< what stands for the value in a usage line, e.g. "E"
  const char* help;             ///< one clause without a capital letter and a full stop
  const char* zero = "";        ///< numbers: what 0 stands for, if that is nothing usual
  const char* details = "";     ///< further sentences for a manual
  Unit unit = Unit::kPlain;
  Range range = {};
  /// Not empty: 0, the default in C++, is outside of the range and means "not set"; this text says
  /// what then counts. Elsewhere the option is left out instead.
  const char* unset = "";
};

/// One value of a report. Its type follows from the member's.
struct ReportField {
  const char* name;  ///< of the member, e.g. "boundary_loops"
  const char* help;  ///< one or more sentences, the last without a full stop
  Unit unit = Unit::kPlain;
};

/// Turns a member's name into that of the JavaScript property: `split_error` -> `splitError`.
std::string camel_case(std::string_view name);

/// Turns a member's name into that of the command line's option: `split_error` -> `split-error`.
std::string kebab_case(std::string_view name);

}  // namespace kdm
