// SPDX-License-Identifier: MIT
// After R. Giulietti, "The Schubfach way to render doubles" (2020). What reads back as a number
// v = c * 2^q lies between the middles of v and its neighbours. With 10^k the largest power of ten
// that is not wider than this interval, a multiple of 10^k lies in it, at most one of 10^(k+1), and
// none that is shorter still unless it ends in zeros. So two candidates on either side of v are all
// there is to look at.
#include "text/decimal.h"

#include <array>
#include <bit>
#include <cstring>
#include <limits>

namespace kdm {
namespace {

__extension__ using Wide = unsigned __int128;

constexpr std::uint64_t high_half(Wide value) { return static_cast<std::uint64_t>(value >> 64); }
constexpr std::uint64_t low_half(Wide value) { return static_cast<std::uint64_t>(value); }

// floor(e * log10(2)), floor(e * log10(2) + log10(3/4)) and floor(e * log2(10)), for |e| < 1200.
constexpr int log10_of_pow2(int e) { return (e * 1262611) >> 22; }
constexpr int log10_of_three_quarters_pow2(int e) { return (e * 1262611 - 524031) >> 22; }
constexpr int log2_of_pow10(int e) { return (e * 1741647) >> 19; }

// Powers of ten are kept at every 27th exponent: 5^27 is the largest power of 5 below 2^64.
constexpr int kStep = 27;
constexpr int kFirst = -11;  // 10^(kFirst * kStep) is the first
constexpr int kCount = 24;

constexpr std::array<std::uint64_t, kStep + 1> kPowersOfFive = [] {
  std::array<std::uint64_t, kStep + 1> powers{1};
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = 5 * powers[i - 1];
  return powers;
}();

// The leading 192 bits of a number, lowest first, the rest cut off.
using Leading = std::array<std::uint64_t, 3>;

// A whole number of 1,280 bits, lowest first.
constexpr std::size_t kLimbs = 20;
using Whole = std::array<std::uint64_t, kLimbs>;

constexpr void multiply(Whole& number, std::uint64_t factor) {
  std::uint64_t carry = 0;
  for (std::uint64_t& limb : number) {
    const Wide product = Wide{limb} * factor + carry;
    limb = low_half(product);
    carry = high_half(product);
  }
}

constexpr void divide(Whole& number, std::uint64_t divisor) {
  std::uint64_t rest = 0;
  for (std::size_t i = kLimbs; i-- > 0;) {
    const Wide part = Wide{rest} << 64 | number[i];
    number[i] = static_cast<std::uint64_t>(part / divisor);
    rest = static_cast<std::uint64_t>(part % divisor);
  }
}

constexpr Leading leading_bits(const Whole& number) {
  std::size_t top = kLimbs - 1;
  while (number[top] == 0) --top;
  const int shift = std::countl_zero(number[top]);
  const auto limb = [&](std::size_t below) {
    return below <= top ? number[top - below] : std::uint64_t{0};
  };
  Leading leading{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Wide pair = Wide{limb(2 - i)} << 64 | limb(3 - i);
    leading[i] = high_half(pair << shift);
  }
  return leading;
}

// 5^(27 a) for a from kFirst on, which has the bits of 10^(27 a).
constexpr std::array<Leading, kCount> kPowers = [] {
  std::array<Leading, kCount> powers{};
  Whole up{1};
  for (int a = 0; a < kFirst + kCount; ++a) {
    powers[static_cast<std::size_t>(a - kFirst)] = leading_bits(up);
    multiply(up, kPowersOfFive[kStep]);
  }
  Whole down{};
  down[kLimbs - 1] = std::uint64_t{1} << 63;
  for (int a = -1; a >= kFirst; --a) {
    divide(down, kPowersOfFive[kStep]);
    powers[static_cast<std::size_t>(a - kFirst)] = leading_bits(down);
  }
  return powers;
}();

// Returns floor(power * factor / 2^128), the last bit set if anything is cut off: that keeps
// comparisons with even numbers right. The power's excess is below 1 in the last place but one.
std::uint64_t scaled(const Bits128& power, std::uint64_t factor) {
  const Wide product = Wide{power.high} * factor + high_half(Wide{power.low} * factor);
  return high_half(product) | (low_half(product) > 1 ? 1 : 0);
}

// `narrow`: the neighbour below is half as far away as the one above.
Decimal shortest(std::uint64_t c, int q, bool narrow) {
  const int k = narrow ? log10_of_three_quarters_pow2(q) : log10_of_pow2(q);
  const Bits128 power = power_of_ten(-k);
  const int shift = q + log2_of_pow10(-k) + 1;
  // The value and the ends of its interval, in quarters of 10^k. Even numbers own their ends.
  const std::uint64_t value = scaled(power, (4 * c) << shift);
  const std::uint64_t open = c & 1;
  const std::uint64_t least = scaled(power, (4 * c - (narrow ? 1 : 2)) << shift) + open;
  const std::uint64_t most = scaled(power, (4 * c + 2) << shift) - open;
  const auto choose = [&](std::uint64_t below, std::uint64_t unit, std::uint64_t& digits) {
    const bool lower_in = least <= 4 * unit * below;
    const bool upper_in = 4 * unit * (below + 1) <= most;
    digits = below + (upper_in ? 1 : 0);
    return lower_in != upper_in;
  };
  std::uint64_t digits = 0;
  int exponent = k;
  const std::uint64_t below = value / 4;
  if (below >= 10 && choose(below / 10, 10, digits)) {
    ++exponent;
  } else if (!choose(below, 1, digits)) {
    const std::uint64_t middle = 4 * below + 2;
    digits = below + (value > middle || (value == middle && below % 2 != 0) ? 1 : 0);
  }
  for (; digits % 10 == 0; ++exponent) digits /= 10;
  return {digits, exponent};
}

template <typename Real, typename Bits>
Decimal shortest_of(Real value) {
  constexpr int kFraction = std::numeric_limits<Real>::digits - 1;
  constexpr int kLeast = std::numeric_limits<Real>::min_exponent - 1 - kFraction;
  constexpr Bits kHidden = Bits{1} << kFraction;
  Bits bits;
  static_assert(sizeof bits == sizeof value);
  std::memcpy(&bits, &value, sizeof bits);
  const Bits fraction = bits & (kHidden - 1);
  const int exponent = static_cast<int>(bits >> kFraction);
  if (exponent == 0) return shortest(fraction, kLeast, false);
  return shortest(kHidden | fraction, kLeast - 1 + exponent, fraction == 0 && exponent > 1);
}

}  // namespace

Bits128 power_of_ten(int exponent) {
  const int block = (exponent - kFirst * kStep) / kStep;
  const Leading& base = kPowers[static_cast<std::size_t>(block)];
  const std::uint64_t five =
      kPowersOfFive[static_cast<std::size_t>(exponent - (block + kFirst) * kStep)];
  Wide sum = high_half(Wide{base[0]} * five);
  sum += Wide{base[1]} * five;
  const std::uint64_t third = low_half(sum);
  const Wide leading = Wide{base[2]} * five + high_half(sum);
  const int shift = std::countl_zero(high_half(leading));
  const Wide power = (leading << shift | (shift == 0 ? 0 : third >> (64 - shift))) + 1;
  return {high_half(power), low_half(power)};
}

Decimal shortest_decimal(double value) { return shortest_of<double, std::uint64_t>(value); }
Decimal shortest_decimal(float value) { return shortest_of<float, std::uint32_t>(value); }

}  // namespace kdm
