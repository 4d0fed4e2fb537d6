// SPDX-License-Identifier: MIT
// Takes numbers, and words messages.
#include "io/text_scanner.h"

#include <fast_float/fast_float.h>

#include <cmath>
#include <limits>

#include "kdmanifold/error.h"
#include "text/compose.h"

namespace kdm {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// "-0,5" and "1,25e-3". A second call of fast_float would keep compilers from inlining the first.
bool has_decimal_comma(std::string_view word) {
  std::size_t at = 0;
  const auto skip_sign = [&] { at += at < word.size() && (word[at] == '-' || word[at] == '+'); };
  const auto skip_digits = [&] {
    const std::size_t first = at;
    while (at < word.size() && is_digit(word[at])) ++at;
    return at > first;
  };
  skip_sign();
  skip_digits();
  if (at == word.size() || word[at++] != ',' || !skip_digits()) return false;
  if (at < word.size() && (word[at] == 'e' || word[at] == 'E')) {
    ++at;
    skip_sign();
    if (!skip_digits()) return false;
  }
  return at == word.size();
}

// "1.#QNAN" and the like are what Microsoft's older C library writes.
bool is_microsoft_nan(std::string_view word) {
  const std::size_t mark = word.find(".#");
  if (mark == std::string_view::npos || mark == 0 || !is_digit(word[mark - 1])) return false;
  const std::string_view kind = word.substr(mark + 2);
  for (const std::string_view known : {"QNAN", "SNAN", "IND", "INF"}) {
    if (kind.substr(0, known.size()) == known) return true;
  }
  return false;
}

}  // namespace

bool TextScanner::find_word_anywhere() {
  while (at_line_end()) {
    if (at_end()) return false;
    skip_line();
  }
  return true;
}

std::string_view TextScanner::rest_of_word() const {
  TextScanner rest = *this;
  return rest.word();
}

void TextScanner::fail_number(const char* what) const {
  const std::string_view word = rest_of_word();
  if (has_decimal_comma(word)) {
    fail(compose("{} is {}, with a decimal comma; a decimal point is expected", what,
                 in_quotes(word)));
  }
  fail_expected(what);
}

double TextScanner::number(const char* what) {
  skip_blanks();
  const TextScanner start = *this;
  const double value = coordinate(what);
  if (std::isfinite(value)) return value;
  fail(compose("{} is {}, which is not a finite number", what, in_quotes(start.rest_of_word())));
}

double TextScanner::coordinate(const char* what) {
  skip_blanks();
  const char* first = at_;
  // from_chars takes no plus sign, so it is skipped. No second sign may follow it.
  if (!at_end() && *first == '+') {
    ++first;
    if (first == end_ || !(is_digit(*first) || *first == '.')) fail_number(what);
  }
  double value = 0;
  const fast_float::from_chars_result result = fast_float::from_chars(first, end_, value);
  // A number out of range gives infinity, or zero, which is the nearest double.
  if (result.ec == std::errc::invalid_argument || result.ptr == first) fail_number(what);
  const char* word = at_;
  at_ = result.ptr;
  if (at_delimiter()) return value;
  at_ = word;
  if (!is_microsoft_nan(rest_of_word())) fail_number(what);
  this->word();
  return std::numeric_limits<double>::quiet_NaN();
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
  fail(compose("{} is expected, not {}", what, in_quotes(rest.word())));
}

std::string in_quotes(std::string_view bytes) {
  constexpr std::size_t kLongest = 32;
  std::string text = "'";
  for (char c : bytes.substr(0, kLongest)) text += c >= ' ' && c <= '~' ? c : '?';
  if (bytes.size() > kLongest) text += "...";
  return text + "'";
}

}  // namespace kdm
