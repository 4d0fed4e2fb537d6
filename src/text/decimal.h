// SPDX-License-Identifier: MIT
// The shortest decimal that reads back as the same floating-point number.
#pragma once

#include <cstdint>

namespace kdm {

/// digits * 10^exponent. The digits do not end in 0.
struct Decimal {
  std::uint64_t digits;
  int exponent;
};

/// Return the decimal with the fewest digits among those that are nearer to `value` than to any
/// other number of its type, and of these the one nearest to it. The value is finite and above 0.
Decimal shortest_decimal(double value);
Decimal shortest_decimal(float value);

/// The 128 bits of a number, highest first.
struct Bits128 {
  std::uint64_t high, low;
};

/// Returns the leading 128 bits of 10^exponent (from -292 to 324), plus one in the last place: just
/// above what the power divided by a power of 2 is.
Bits128 power_of_ten(int exponent);

}  // namespace kdm
