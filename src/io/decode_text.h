// SPDX-License-Identifier: MIT
// Text as files have it: UTF-16 becomes UTF-8, and padding behind the text is cut off.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/bytes.h"

namespace kdm {

/// Tells whether a file is UTF-16: it begins with a byte order mark, or every other one of its
/// first bytes is zero and the others are ASCII text. Returns the order of the bytes.
std::optional<ByteOrder> utf16_order(std::string_view bytes);

/// Returns the text as UTF-8, without a byte order mark. What is no character becomes U+FFFD; a
/// single byte at the end is left out.
std::string utf8_from_utf16(std::string_view bytes, ByteOrder order);

/// Returns the text without the zero bytes and the Ctrl-Z (end of file in CP/M and DOS) at its end.
std::string_view without_padding(std::string_view text);

/// Tells whether the first 1,000 bytes are text: no control characters but white space. Letters may
/// be of any encoding that contains ASCII.
bool looks_like_text(std::string_view bytes);

}  // namespace kdm
