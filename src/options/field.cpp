// SPDX-License-Identifier: MIT
// Names and ranges of fields as users read them.
#include "kdmanifold/field.h"
#include "text/compose.h"

namespace kdm {

std::string range_text(const Range& range) {
  if (!has_end(range)) return compose("from {} on", range.least);
  return compose("from {} to {}{}", range.least, range.most_excluded ? "below " : "", range.most);
}

std::string camel_case(std::string_view name) {
  std::string text;
  bool raise = false;
  for (const char c : name) {
    if (c != '_') text += raise ? static_cast<char>(c - 'a' + 'A') : c;
    raise = c == '_';
  }
  return text;
}

std::string kebab_case(std::string_view name) {
  std::string text(name);
  for (char& c : text) {
    if (c == '_') c = '-';
  }
  return text;
}

}  // namespace kdm
