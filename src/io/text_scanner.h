// SPDX-License-Identifier: MIT
// Takes words and numbers from text, and knows the line that it is on. Numbers are read in the same
// way whatever the locale is (by fast_float). CR, LF and CR LF all end a line. A byte order mark at
// the beginning is passed over.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace kdm {

/// What a format's text allows beside words and line ends.
struct TextSyntax {
  bool comments = false;       ///< `#` at the start of a word: the rest of the line is ignored
  bool continuations = false;  ///< a backslash before the line end joins the next line
};

/// Moves through a text word by word. A copy is a place in the text to which one can go back.
class TextScanner {
 public:
  /// `name` is what messages call the text. Both views must outlive the scanner.
  TextScanner(std::string_view text, std::string_view name, TextSyntax syntax = {})
      : begin_(text.data()),
        at_(text.data()),
        end_(text.data() + text.size()),
        name_(name),
        syntax_(syntax) {
    take("\xef\xbb\xbf");
  }

  bool at_end() const { return at_ == end_; }
  std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }
  std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - at_); }
  std::size_t line() const { return line_; }

  /// Skips blanks within the line, and tells whether nothing else follows but the line's end or a
  /// comment.
  bool at_line_end() {
    skip_blanks();
    return at_end() || is_newline(*at_) || (syntax_.comments && *at_ == '#');
  }

  /// Goes to the start of the next line.
  void skip_line() {
    while (!at_end() && !is_newline(*at_)) ++at_;
    skip_newline();
  }

  /// Goes to the next word, over line ends and comments. Returns false if there is none.
  bool find_word() {
    // A single blank, the usual case. No white space and no `#` is above '#'.
    if (bytes_left() >= 2 && *at_ == ' ' && at_[1] > '#' && at_[1] != '\\') {
      ++at_;
      return true;
    }
    return find_word_anywhere();
  }

  /// Takes the next word of this line. Returns an empty one at the line's end.
  std::string_view word() {
    if (at_line_end()) return {};
    const char* first = at_;
    while (!at_delimiter()) ++at_;
    return {first, static_cast<std::size_t>(at_ - first)};
  }

  /// Returns the next character if the word goes on, else 0.
  char peek() const { return at_delimiter() ? '\0' : *at_; }
  void skip_char() { ++at_; }
  /// Takes `prefix` if the text goes on with it, and tells whether it did.
  bool take(std::string_view prefix) {
    if (std::string_view(at_, bytes_left()).substr(0, prefix.size()) != prefix) return false;
    at_ += prefix.size();
    return true;
  }

  /// Takes the next word of this line as a finite number; `what` names it in messages. Throws
  /// `kParseError` if the word is no finite number.
  double number(const char* what);
  /// Takes the next word of this line as a number, which may not be finite: "nan", "inf", and what
  /// C libraries write for them. Throws `kParseError` if the word is nothing of these.
  double coordinate(const char* what);
  /// Takes the next word of this line as an integer; `what` names it in messages. Throws
  /// `kParseError` if the word is no integer.
  std::int64_t integer(const char* what);
  /// Takes an integer at the beginning of the next word; the rest of the word stays to be taken.
  std::int64_t integer_prefix(const char* what);

  /// Throw `kParseError` with the name of the text, a line (the current one, or `line`) and the
  /// message.
  [[noreturn]] void fail(std::string_view message) const { fail_at(line_, message); }
  [[noreturn]] void fail_at(std::size_t line, std::string_view message) const;
  /// Throws `kParseError`, saying what is expected here and what is there instead.
  [[noreturn]] void fail_expected(std::string_view what) const;

 private:
  bool find_word_anywhere();
  [[noreturn]] void fail_number(const char* what) const;
  std::string_view rest_of_word() const;

  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  static bool is_newline(char c) { return c == '\n' || c == '\r'; }
  bool at_continuation() const {
    return syntax_.continuations && *at_ == '\\' && (at_ + 1 == end_ || is_newline(at_[1]));
  }
  bool at_delimiter() const {
    return at_end() || is_blank(*at_) || is_newline(*at_) || at_continuation();
  }
  void skip_blanks() {
    for (; !at_end(); ++at_) {
      if (is_blank(*at_)) continue;
      if (!at_continuation()) return;
      ++at_;
      skip_newline();
      --at_;
    }
  }
  void skip_newline() {
    if (at_end()) return;
    if (*at_ == '\r' && at_ + 1 != end_ && at_[1] == '\n') ++at_;
    ++at_;
    ++line_;
  }

  const char* begin_;
  const char* at_;
  const char* end_;
  std::string_view name_;
  TextSyntax syntax_;
  std::size_t line_ = 1;
};

/// Returns bytes of a file in quotes, as they can stand in a message of one line: printable, and
/// not more than 32.
std::string in_quotes(std::string_view bytes);

}  // namespace kdm
