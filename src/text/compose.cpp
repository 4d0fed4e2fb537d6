// SPDX-License-Identifier: MIT
#include "text/compose.h"

namespace kdm {

std::string fill_in(std::string_view pattern, std::initializer_list<TextPiece> pieces) {
  std::string message;
  for (const TextPiece& piece : pieces) {
    const std::size_t hole = pattern.find("{}");
    message.append(pattern.substr(0, hole));
    message.append(piece.text());
    pattern.remove_prefix(hole + 2);
  }
  message.append(pattern);
  return message;
}

}  // namespace kdm
