// SPDX-License-Identifier: MIT
// Reads option objects and makes report objects by the tables in kdmanifold/options.h and
// reports.h. Properties are the members' names in camel case.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "kdmanifold/error.h"
#include "kdmanifold/options.h"
#include "kdmanifold/reports.h"
#include "marshal.h"

namespace kdm::wasm {

/// Returns the place of the word among those that are legal; `name` is what the error calls the
/// option.
inline std::size_t find_word(const val& word, const char* name,
                             std::span<const char* const> legal) {
  const std::string text = word.as<std::string>();
  std::string all;
  for (std::size_t i = 0; i < legal.size(); ++i) {
    if (text == legal[i]) return i;
    all += i == 0 ? " is none of " : ", ";
    all += legal[i];
  }
  throw Error(ErrorCode::kInvalidOption, std::string(name) + ": '" + text + "'" + all);
}

/// Returns what the word stands for. What is not the choice's own is compiled once for all.
template <typename Choice>
Choice to_choice(const val& word, const char* name) {
  std::array<const char*, kBareWords<Choice>.size()> legal;
  for (std::size_t i = 0; i < legal.size(); ++i) legal[i] = kBareWords<Choice>[i].first;
  return kBareWords<Choice>[find_word(word, name, legal)].second;
}

/// Copies an array of whole numbers, which the wrapper has checked.
inline std::vector<Index> to_list(const val& array) {
  std::vector<Index> list(length(array));
  copy_in(array, list.size(), list.data());
  return list;
}

/// Copies the corners of a box, which the wrapper has checked.
inline BoxCorners to_box(const val& array) {
  BoxCorners corners;
  copy_in(array, corners.size(), corners.data());
  return corners;
}

// Functions below take the name of a field instead of the field, so that compilers drop its help.

/// Reads an option; keeps its default if there is none.
template <typename Value>
void read_option(const val& from, const char* name, Value& target) {
  const val value = from[camel_case(name)];
  if (!present(value)) return;
  if constexpr (std::is_enum_v<Value>) {
    target = to_choice<Value>(value, name);
  } else if constexpr (std::is_same_v<Value, std::optional<bool>>) {
    target = value.as<bool>();
  } else if constexpr (std::is_same_v<Value, std::vector<Index>>) {
    target = to_list(value);
  } else if constexpr (std::is_same_v<Value, std::optional<BoxCorners>>) {
    target = to_box(value);
  } else {
    target = value.as<Value>();
  }
}

/// Reads an object of options. What it lacks keeps its default.
template <typename Options>
Options to_options(const val& from) {
  Options options;
  for_each_field(options, [&](const OptionField& field, auto& target) {
    read_option(from, field.name, target);
  });
  return options;
}

/// Makes a JavaScript value. 64-bit counts become ordinary numbers: they are below 2^53.
template <typename Value>
requires std::is_arithmetic_v<Value> val from_value(Value value) {
  if constexpr (sizeof(Value) == 8) return val(static_cast<double>(value));
  return val(value);
}
inline val from_value(const std::optional<std::uint64_t>& value) {
  return value ? from_value(*value) : val::null();
}
inline val from_value(const Box& box) {
  val to = val::object();
  to.set("min", copy_out("Float64Array", 3, box.min.data()));
  to.set("max", copy_out("Float64Array", 3, box.max.data()));
  return to;
}
inline val from_value(const Deviation& deviation);
inline val from_value(const std::vector<Vec3>& points) {
  return copy_out("Float64Array", 3 * points.size(),
                  reinterpret_cast<const double*>(points.data()));
}
template <typename Element>
val from_value(const std::vector<Element>& list) {
  return from_indices(list);
}

inline val from_value(const MeshReport& report);

template <typename Value>
void set_field(val& to, const char* name, const Value& value) {
  to.set(camel_case(name), from_value(value));
}

/// Makes an object of a report.
template <typename Report>
val from_report(const Report& report) {
  val to = val::object();
  for_each_field(report, [&](const ReportField& field, const auto& value) {
    set_field(to, field.name, value);
  });
  return to;
}
inline val from_value(const MeshReport& report) { return from_report(report); }
inline val from_value(const Deviation& deviation) { return from_report(deviation); }

}  // namespace kdm::wasm
