// SPDX-License-Identifier: MIT
// Takes integers of any length, and words messages.
#include "io/bytes.h"

#include "kdmanifold/error.h"
#include "text/compose.h"

namespace kdm {

std::uint64_t ByteReader::take_varint(std::uint64_t most, std::string_view what) {
  std::uint64_t value = 0;
  for (int shift = 0; shift < 64; shift += 7) {
    require(1, 1, what);
    const auto byte = take_unsigned<std::uint8_t>();
    value |= std::uint64_t{byte & 0x7fu} << shift;
    if (byte < 0x80) {
      // The tenth byte has room for one bit, and no number needs a last byte of 0.
      const bool shortest = byte != 0 || shift == 0;
      if (value <= most && shortest && (shift < 63 || byte <= 1)) return value;
      break;
    }
  }
  fail(compose("{} should be a number up to {}", what, most));
}

void ByteReader::fail_at(std::size_t offset, std::string_view message) const {
  throw Error(ErrorCode::kParseError, compose("{}: byte {}: {}", name_, offset, message));
}

void ByteReader::fail_short(std::uint64_t count, std::size_t size, std::string_view what) const {
  fail(compose("{} x {} of {} bytes should follow, but the file ends at byte {}", count, what, size,
               bytes_.size()));
}

}  // namespace kdm
