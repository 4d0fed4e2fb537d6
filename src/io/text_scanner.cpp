// SPDX-License-Identifier: MIT
// Takes numbers, and words messages.
#include "io/text_scanner.h"

#include <fast_float/fast_float.h>

#include <cmath>

#include "kdmanifold/error.h"
#include "text/compose.h"

namespace kdm {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

double TextScanner::number(const char* what) {
  skip_blanks();
  const char* first = at_;
  // from_chars takes no plus sign, so it is skipped. No second sign may follow it.
  if (!at_end() && *first == '+') {
    ++first;
    if (first == end_ || !(is_digit(*first) || *first == '.')) fail_expected(what);
  }
  double value = 0;
  const fast_float::from_chars_result result = fast_float::from_chars(first, end_, value);
  // A number out of range gives infinity, which is refused below, or zero, which is the nearest
  // double.
  if (result.ec == std::errc::invalid_argument || result.ptr == first) fail_expected(what);
  const char* word = at_;
  at_ = result.ptr;
  if (!at_delimiter()) {
    at_ = word;
    fail_expected(what);
  }
  if (!std::isfinite(value)) {
    fail(compose("{} is {}, which is not a finite number", what,
                 quoted({word, static_cast<std::size_t>(at_ - word)})));
  }
  return value;
}

std::int64_t TextScanner::integer_prefix(const char* what) {
  skip_blanks();
  const char* digit = at_;
  const bool negative = !at_end() && *digit == '-';
  if (!at_end() && (*digit == '-' || *digit == '+')) ++digit;
  const char* first = digit;
  std::int64_t value = 0;
  // Any 18 digits fit into 64 bits, and no count or index is longer.
  while (digit != end_ && is_digit(*digit) && digit - first < 18) {
    value = value * 10 + (*digit++ - '0');
  }
  if (digit == first || (digit != end_ && is_digit(*digit))) fail_expected(what);
  at_ = digit;
  return negative ? -value : value;
}

std::int64_t TextScanner::integer(const char* what) {
  skip_blanks();
  const char* word = at_;
  const std::int64_t value = integer_prefix(what);
  if (!at_delimiter()) {
    at_ = word;
    fail_expected(what);
  }
  return value;
}

void TextScanner::fail_at(std::size_t line, std::string_view message) const {
  throw Error(ErrorCode::kParseError, compose("{}: line {}: {}", name_, line, message));
}

void TextScanner::fail_expected(std::string_view what) const {
  if (at_end()) fail(compose("the file ends where {} is expected", what));
  if (is_newline(*at_)) fail(compose("the line ends where {} is expected", what));
  TextScanner rest = *this;
  fail(compose("{} is expected, not {}", what, quoted(rest.word())));
}

std::string quoted(std::string_view bytes) {
  constexpr std::size_t kLongest = 32;
  std::string text = "'";
  for (char c : bytes.substr(0, kLongest)) text += c >= ' ' && c <= '~' ? c : '?';
  if (bytes.size() > kLongest) text += "...";
  return text + "'";
}

}  // namespace kdm
