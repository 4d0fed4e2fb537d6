// SPDX-License-Identifier: MIT
// Checks options against the table in kdmanifold/options.h.

#include "kdmanifold/error.h"
#include "kdmanifold/options.h"
#include "text/compose.h"

namespace kdm {
namespace {

[[noreturn]] void refuse(const char* name, double value, const std::string& legal) {
  throw Error(ErrorCode::kInvalidOption, compose("{} is {}; it must be {}", name, value, legal));
}

void check_number(const OptionField& field, double value, const char* kind) {
  const bool may_be_unset = field.unset[0] != '\0';
  if (contains(field.range, value) || (may_be_unset && value == 0)) return;
  std::string legal = compose("a {} {}", kind, range_text(field.range));
  if (may_be_unset) legal += compose(", or 0, which stands for {}", field.unset);
  refuse(field.name, value, legal);
}

template <typename Options>
void check_fields(const Options& options) {
  for_each_field(options, [](const OptionField& field, const auto& value) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_enum_v<Value>) {
      if (word_of(value) != nullptr) return;
      refuse(field.name, static_cast<double>(value), "one of " + joined_words<Value>(", "));
    } else if constexpr (!std::is_same_v<Value, bool>) {
      check_number(field, value, std::is_integral_v<Value> ? "whole number" : "number");
    }
  });
}

}  // namespace

void check_options(const BuildOptions& options) { check_fields(options); }
void check_options(const ExtractOptions& options) { check_fields(options); }

}  // namespace kdm
