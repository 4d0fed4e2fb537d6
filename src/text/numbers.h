// SPDX-License-Identifier: MIT
// Numbers as text, the same everywhere and whatever the locale is.
#pragma once

#include <concepts>
#include <cstdint>

namespace kdm {

/// No number takes more characters: -2.2250738585072014e-308.
inline constexpr int kLongestNumber = 24;

/// Write a number and return the end of the text, for which `kLongestNumber` characters must be
/// there. Floating-point numbers have as few digits as tell them from all others of their type,
/// with an exponent below 1e-4 and from 1e16 on.
char* write_number(char* to, std::uint64_t value);
char* write_number(char* to, std::int64_t value);
char* write_number(char* to, double value);
char* write_number(char* to, float value);

template <std::unsigned_integral Whole>
char* write_number(char* to, Whole value) {
  return write_number(to, std::uint64_t{value});
}
template <std::signed_integral Whole>
char* write_number(char* to, Whole value) {
  return write_number(to, std::int64_t{value});
}

}  // namespace kdm
