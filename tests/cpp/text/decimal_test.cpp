// SPDX-License-Identifier: MIT
// Shortest decimals, held against the standard library's; powers of ten against whole numbers of
// any length.
#include "text/decimal.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace kdm {
namespace {

// A whole number in 32-bit digits, lowest first.
using Digits = std::vector<std::uint32_t>;

Digits power_of_two(std::size_t exponent) {
  Digits digits(exponent / 32 + 1, 0);
  digits.back() = 1u << exponent % 32;
  return digits;
}

void multiply_by_five(Digits& digits) {
  std::uint64_t carry = 0;
  for (std::uint32_t& digit : digits) {
    carry += std::uint64_t{5} * digit;
    digit = static_cast<std::uint32_t>(carry);
    carry >>= 32;
  }
  if (carry != 0) digits.push_back(static_cast<std::uint32_t>(carry));
}

void divide_by_five(Digits& digits) {
  std::uint64_t rest = 0;
  for (std::size_t i = digits.size(); i-- > 0;) {
    rest = rest << 32 | digits[i];
    digits[i] = static_cast<std::uint32_t>(rest / 5);
    rest %= 5;
  }
  while (digits.back() == 0) digits.pop_back();
}

// The leading 128 bits, cut off, plus one.
std::string just_above(const Digits& digits) {
  std::string bits;
  for (std::size_t i = digits.size(); i-- > 0;) {
    for (int bit = 31; bit >= 0; --bit) bits += digits[i] >> bit & 1 ? '1' : '0';
  }
  bits.erase(0, bits.find('1'));
  bits.resize(128, '0');
  std::size_t last = bits.size();
  while (last-- > 0 && bits[last] == '1') bits[last] = '0';
  bits[last] = '1';
  return bits;
}

std::string text_of(const Bits128& number) {
  std::string bits;
  for (const std::uint64_t half : {number.high, number.low}) {
    for (int bit = 63; bit >= 0; --bit) bits += half >> bit & 1 ? '1' : '0';
  }
  return bits;
}

TEST(Decimal, PowersOfTenAreExact) {
  Digits up = power_of_two(0);
  for (int exponent = 0; exponent <= 324; ++exponent) {
    EXPECT_EQ(text_of(power_of_ten(exponent)), just_above(up)) << exponent;
    multiply_by_five(up);
  }
  Digits down = power_of_two(1024);
  for (int exponent = -1; exponent >= -292; --exponent) {
    divide_by_five(down);
    EXPECT_EQ(text_of(power_of_ten(exponent)), just_above(down)) << exponent;
  }
}

// Returns digits and exponent as the standard library has them: d.dddde+xx.
template <typename Real>
Decimal expected(Real value) {
  char text[40];
  const std::to_chars_result result =
      std::to_chars(text, text + sizeof text, value, std::chars_format::scientific);
  const std::string_view all(text, static_cast<std::size_t>(result.ptr - text));
  const std::size_t e = all.find('e');
  Decimal decimal{0, std::atoi(std::string(all.substr(e + 1)).c_str())};
  for (const char c : all.substr(0, e)) {
    if (c != '.') decimal.digits = decimal.digits * 10 + static_cast<std::uint64_t>(c - '0');
  }
  decimal.exponent -= e > 1 ? static_cast<int>(e) - 2 : 0;
  return decimal;
}

template <typename Real>
bool same(Real value) {
  const Decimal decimal = shortest_decimal(value);
  const Decimal other = expected(value);
  EXPECT_EQ(decimal.digits, other.digits) << value;
  EXPECT_EQ(decimal.exponent, other.exponent) << value;
  return decimal.digits == other.digits && decimal.exponent == other.exponent;
}

template <typename Real, typename Bits>
void check_all_exponents() {
  constexpr int kFraction = std::numeric_limits<Real>::digits - 1;
  constexpr Bits kEnd = std::bit_cast<Bits>(std::numeric_limits<Real>::infinity());
  for (Bits power = 0; power < kEnd; power += Bits{1} << kFraction) {
    for (int step = -3; step <= 3; ++step) {
      const Bits bits = power + static_cast<Bits>(step);
      if (bits == 0 || bits >= kEnd) continue;
      if (!same(std::bit_cast<Real>(bits))) return;
    }
  }
  ASSERT_TRUE(same(std::numeric_limits<Real>::max()));
}

TEST(Decimal, BesidePowersOfTwo) {
  check_all_exponents<double, std::uint64_t>();
  check_all_exponents<float, std::uint32_t>();
}

TEST(Decimal, RandomNumbers) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 200'000; ++i) {
    const std::uint64_t bits = random();
    const double wide = std::abs(std::bit_cast<double>(bits));
    const float narrow = std::abs(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    ASSERT_TRUE(!std::isfinite(wide) || wide == 0 || same(wide));
    ASSERT_TRUE(!std::isfinite(narrow) || narrow == 0 || same(narrow));
  }
}

TEST(Decimal, FewDigits) {
  for (int i = 1; i < 100'000; i += 7) {
    ASSERT_TRUE(same(i / 1000.0));
    ASSERT_TRUE(same(static_cast<float>(i) / 1000));
    ASSERT_TRUE(same(i * 1e15));
  }
}

}  // namespace
}  // namespace kdm
