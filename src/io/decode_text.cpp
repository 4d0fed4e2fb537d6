// SPDX-License-Identifier: MIT
// Decodes UTF-16, and tells text from other bytes.
#include "io/decode_text.h"

#include <algorithm>
#include <cstdint>

namespace kdm {
namespace {

constexpr std::uint32_t kReplacement = 0xfffd;

bool is_text_byte(char c) {
  return static_cast<unsigned char>(c) >= ' ' || (c >= '\t' && c <= '\r');
}

bool is_ascii_text(char c) { return is_text_byte(c) && static_cast<unsigned char>(c) < 0x7f; }

void append_utf8(std::string& out, std::uint32_t code) {
  const auto add = [&](std::uint32_t byte) { out += static_cast<char>(byte); };
  if (code < 0x80) return add(code);
  if (code < 0x800) {
    add(0xc0 | code >> 6);
  } else {
    if (code < 0x10000) {
      add(0xe0 | code >> 12);
    } else {
      add(0xf0 | code >> 18);
      add(0x80 | (code >> 12 & 0x3f));
    }
    add(0x80 | (code >> 6 & 0x3f));
  }
  add(0x80 | (code & 0x3f));
}

}  // namespace

std::optional<ByteOrder> utf16_order(std::string_view bytes) {
  if (bytes.substr(0, 2) == "\xff\xfe") return ByteOrder::kLittle;
  if (bytes.substr(0, 2) == "\xfe\xff") return ByteOrder::kBig;
  const std::size_t sample = std::min<std::size_t>(bytes.size(), 64) & ~std::size_t{1};
  if (sample < 8) return std::nullopt;
  bool little = true, big = true;
  for (std::size_t i = 0; i < sample; i += 2) {
    little = little && is_ascii_text(bytes[i]) && bytes[i + 1] == 0;
    big = big && bytes[i] == 0 && is_ascii_text(bytes[i + 1]);
  }
  if (little) return ByteOrder::kLittle;
  if (big) return ByteOrder::kBig;
  return std::nullopt;
}

std::string utf8_from_utf16(std::string_view bytes, ByteOrder order) {
  ByteReader reader(bytes, {}, order, 0);
  std::string text;
  text.reserve(bytes.size() / 2);
  std::uint32_t high = 0;  // the first half of a pair, which waits for the second
  while (reader.bytes_left() >= 2) {
    const std::uint32_t unit = reader.take_unsigned<std::uint16_t>();
    const bool is_low = unit >= 0xdc00 && unit < 0xe000;
    if (high != 0 && is_low) {
      append_utf8(text, 0x10000 + ((high - 0xd800) << 10) + (unit - 0xdc00));
      high = 0;
      continue;
    }
    if (high != 0) append_utf8(text, kReplacement);
    high = unit >= 0xd800 && unit < 0xdc00 ? unit : 0;
    if (high != 0 || (unit == 0xfeff && text.empty())) continue;
    append_utf8(text, is_low ? kReplacement : unit);
  }
  if (high != 0) append_utf8(text, kReplacement);
  return text;
}

std::string_view without_padding(std::string_view text) {
  const std::size_t last = text.find_last_not_of(std::string_view("\0\x1a \t\r\n", 6));
  const std::size_t end = last == std::string_view::npos ? 0 : last + 1;
  const std::size_t padding = text.find_first_of(std::string_view("\0\x1a", 2), end);
  return text.substr(0, padding);
}

bool looks_like_text(std::string_view bytes) {
  const std::string_view sample = bytes.substr(0, 1000);
  return std::all_of(sample.begin(), sample.end(), is_text_byte);
}

}  // namespace kdm
