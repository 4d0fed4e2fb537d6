// SPDX-License-Identifier: MIT
// Composes messages: compose("{} is {}", name, 0.5).
#pragma once

#include <concepts>
#include <initializer_list>
#include <string>
#include <string_view>

#include "text/numbers.h"

namespace kdm {

/// A text, or a number as text.
class TextPiece {
 public:
  explicit TextPiece(std::string_view text) : text_(text.data()), length_(text.size()) {}
  explicit TextPiece(char letter) : length_(1) { own_[0] = letter; }
  template <typename Number>
  requires std::floating_point<Number> ||
      (std::integral<Number> && !std::same_as<Number, bool>)explicit TextPiece(Number value)
      : length_(static_cast<std::size_t>(write_number(own_, value) - own_)) {}

  std::string_view text() const { return {text_ != nullptr ? text_ : own_, length_}; }

 private:
  const char* text_ = nullptr;  // none: the text is our own
  std::size_t length_;
  char own_[kLongestNumber];
};

/// A text with `{}` for each of `holes` pieces. That their number is right is checked by the
/// compiler.
template <std::size_t holes>
class Pattern {
 public:
  consteval Pattern(const char* text) : text_(text) {
    std::size_t found = 0;
    for (std::size_t i = 0; i + 1 < text_.size(); ++i) found += text_.substr(i, 2) == "{}";
    if (found != holes) throw "as many values as {} are needed";
  }
  std::string_view text() const { return text_; }

 private:
  std::string_view text_;
};

/// Puts each piece in the place of a `{}`.
std::string fill_in(std::string_view pattern, std::initializer_list<TextPiece> pieces);

/// Returns the pattern with a text, a letter or a number in the place of each `{}`.
template <typename... Values>
std::string compose(Pattern<sizeof...(Values)> pattern, const Values&... values) {
  return fill_in(pattern.text(), {TextPiece(values)...});
}

}  // namespace kdm
