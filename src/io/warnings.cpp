// SPDX-License-Identifier: MIT
// Words the warnings.
#include "io/warnings.h"

#include "kdmanifold/error.h"
#include "text/compose.h"

namespace kdm {

std::string Warnings::count_text(Skip why, std::uint64_t count) {
  return compose(
      "{} {} {}", count, count == 1 ? "face has" : "faces have",
      why == Skip::kNotFinite ? "a coordinate that is not a number" : "fewer than three corners");
}

std::vector<Warning> Warnings::take() {
  for (const Skip why : {Skip::kNotFinite, Skip::kFewCorners}) {
    const auto& [count, first] = kinds_[static_cast<std::size_t>(why)];
    if (count == 0) continue;
    add("FACES_SKIPPED", compose("{}; skipped; {} at {} {}", count_text(why, count),
                                 count == 1 ? "it is" : "the first is", first.unit, first.number));
  }
  return std::move(others_);
}

void Warnings::fail_if_skipped(std::string_view name) const {
  for (const Skip why : {Skip::kNotFinite, Skip::kFewCorners}) {
    const auto& [count, first] = kinds_[static_cast<std::size_t>(why)];
    if (count == 0) continue;
    throw Error(ErrorCode::kParseError, compose("{}: {} {}: no face is left: {}", name, first.unit,
                                                first.number, count_text(why, count)));
  }
}

}  // namespace kdm
