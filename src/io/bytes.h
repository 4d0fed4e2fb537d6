// SPDX-License-Identifier: MIT
// Reads numbers from binary files and appends them to strings. Numbers are put together from bytes
// by shifts, so the order in which the machine keeps bytes does not matter.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace kdm {

/// The order of the bytes of a number in a file: lowest or highest first.
enum class ByteOrder { kLittle, kBig };

/// Reads numbers one after the other. Only `require` and `take_varint` check that the bytes are
/// there; call `require` before anything else is looked at, taken or skipped.
class ByteReader {
 public:
  /// Starts at byte `offset`. `name` is what messages call the file. Both views must outlive the
  /// reader.
  ByteReader(std::string_view bytes, std::string_view name, ByteOrder order, std::size_t offset)
      : bytes_(bytes), name_(name), order_(order), at_(offset) {}

  /// Returns the place of the next byte in the file.
  std::size_t offset() const { return at_; }
  std::size_t bytes_left() const { return bytes_.size() - at_; }

  /// Throws `kParseError` unless `count` items of `size` bytes are left. `what` names an item.
  /// Counts may be as large as they like: no product overflows.
  void require(std::uint64_t count, std::size_t size, std::string_view what) const {
    if (size != 0 && count > bytes_left() / size) fail_short(count, size, what);
  }
  void skip(std::size_t count) { at_ += count; }

  /// Returns the unsigned integer, of as many bytes as the type has, that begins `skipped` bytes
  /// further on.
  template <typename Unsigned>
  Unsigned peek_unsigned(std::size_t skipped) const {
    // Two loops, of which compilers make a single load each.
    const char* first = bytes_.data() + at_ + skipped;
    const auto byte = [first](std::size_t i) { return static_cast<unsigned char>(first[i]); };
    Unsigned value = 0;
    if (order_ == ByteOrder::kLittle) {
      for (std::size_t i = 0; i < sizeof(Unsigned); ++i) {
        value = static_cast<Unsigned>(value | static_cast<Unsigned>(byte(i)) << (8 * i));
      }
    } else {
      for (std::size_t i = 0; i < sizeof(Unsigned); ++i) {
        const std::size_t place = sizeof(Unsigned) - 1 - i;
        value = static_cast<Unsigned>(value | static_cast<Unsigned>(byte(i)) << (8 * place));
      }
    }
    return value;
  }
  /// Takes an unsigned integer of as many bytes as the type has.
  template <typename Unsigned>
  Unsigned take_unsigned() {
    const auto value = peek_unsigned<Unsigned>(0);
    at_ += sizeof(Unsigned);
    return value;
  }
  /// Takes an integer that is written in groups of seven bits, the lowest first; all bytes but the
  /// last have their top bit set. Throws `kParseError` if the bytes end, if the number is above
  /// `most`, or if it is not written as short as possible. `what` names it.
  std::uint64_t take_varint(std::uint64_t most, std::string_view what);
  /// Takes an integer or a floating-point number, which has the size of `Unsigned`.
  template <typename To, typename Unsigned>
  To take() {
    static_assert(sizeof(To) == sizeof(Unsigned));
    const Unsigned bits = take_unsigned<Unsigned>();
    To value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }

  /// Throw `kParseError` with the name of the file, a byte's place (that of the next one, or
  /// `offset`) and the message.
  [[noreturn]] void fail(std::string_view message) const { fail_at(at_, message); }
  [[noreturn]] void fail_at(std::size_t offset, std::string_view message) const;

 private:
  [[noreturn]] void fail_short(std::uint64_t count, std::size_t size, std::string_view what) const;

  std::string_view bytes_;
  std::string_view name_;
  ByteOrder order_;
  std::size_t at_;
};

/// Append a number to a string, its lowest byte first.
inline void append_u8(std::string& out, std::uint8_t value) { out += static_cast<char>(value); }
inline void append_u16(std::string& out, std::uint16_t value) {
  for (int shift = 0; shift < 16; shift += 8) out += static_cast<char>(value >> shift & 0xff);
}
inline void append_u32(std::string& out, std::uint32_t value) {
  char bytes[4];
  for (int i = 0; i < 4; ++i) bytes[i] = static_cast<char>(value >> (8 * i) & 0xff);
  out.append(bytes, 4);
}
inline void append_u64(std::string& out, std::uint64_t value) {
  append_u32(out, static_cast<std::uint32_t>(value));
  append_u32(out, static_cast<std::uint32_t>(value >> 32));
}
inline void append_f64(std::string& out, double value) {
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  append_u64(out, bits);
}
/// Appends an integer as `take_varint` reads it.
inline void append_varint(std::string& out, std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) out += static_cast<char>((value & 0x7f) | 0x80);
  out += static_cast<char>(value);
}
inline void append_f32(std::string& out, float value) {
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  append_u32(out, bits);
}

}  // namespace kdm
