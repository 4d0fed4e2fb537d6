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

// Takes what it needs of a field, so that compilers drop the other texts.
void check_number(const char* name, Range range, const char* unset, double value,
                  const char* kind) {
  const bool may_be_unset = unset[0] != '\0';
  if (contains(range, value) || (may_be_unset && value == 0)) return;
  std::string legal = compose("a {} {}", kind, range_text(range));
  if (may_be_unset) legal += compose(", or 0, which stands for {}", unset);
  refuse(name, value, legal);
}

template <typename Choice>
void check_choice(const char* name, Choice value) {
  if (word_of(value) != nullptr) return;
  refuse(name, static_cast<double>(value), "one of " + joined_words<Choice>(", "));
}

template <typename Options>
void check_fields(const Options& options) {
  for_each_field(options, [](const OptionField& field, const auto& value) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_enum_v<Value>) {
      check_choice(field.name, value);
    } else if constexpr (!std::is_same_v<Value, bool>) {
      check_number(field.name, field.range, field.unset, value,
                   std::is_integral_v<Value> ? "whole number" : "number");
    }
  });
}

}  // namespace

void check_options(const BuildOptions& options) { check_fields(options); }
void check_options(const ExtractOptions& options) { check_fields(options); }

}  // namespace kdm
