// SPDX-License-Identifier: MIT
#include "text/numbers.h"

#include <cmath>
#include <cstring>

#include "text/decimal.h"

namespace kdm {
namespace {

// 00 to 99.
struct Pairs {
  char text[200];
};
constexpr Pairs kPairs = [] {
  Pairs pairs{};
  for (int i = 0; i < 100; ++i) {
    pairs.text[2 * i] = static_cast<char>('0' + i / 10);
    pairs.text[2 * i + 1] = static_cast<char>('0' + i % 10);
  }
  return pairs;
}();

int count_digits(std::uint64_t value) {
  int count = 1;
  for (; value >= 10000; value /= 10000) count += 4;
  return count + (value >= 10) + (value >= 100) + (value >= 1000);
}

// Writes the digits of a number, of which there are `count`.
char* write_digits(char* to, std::uint64_t value, int count) {
  char* at = to + count;
  for (; value >= 100; value /= 100) {
    at -= 2;
    std::memcpy(at, kPairs.text + 2 * (value % 100), 2);
  }
  if (value >= 10) {
    std::memcpy(to, kPairs.text + 2 * value, 2);
  } else {
    *to = static_cast<char>('0' + value);
  }
  return to + count;
}

char* write_text(char* to, const char* text) {
  while (*text != '\0') *to++ = *text++;
  return to;
}

char* write_zeros(char* to, int count) {
  while (count-- > 0) *to++ = '0';
  return to;
}

// Writes digits, all but the first `before` of them behind a point.
char* write_fraction(char* to, std::uint64_t digits, int count, int before) {
  write_digits(to + 1, digits, count);
  for (int i = 0; i < before; ++i) to[i] = to[i + 1];
  to[before] = '.';
  return to + count + 1;
}

char* write_exponent(char* to, int exponent) {
  *to++ = 'e';
  *to++ = exponent < 0 ? '-' : '+';
  const int size = exponent < 0 ? -exponent : exponent;
  if (size < 10) *to++ = '0';
  return write_number(to, size);
}

char* write_decimal(char* to, const Decimal& decimal) {
  const int count = count_digits(decimal.digits);
  const int first = count + decimal.exponent - 1;  // the place of the first digit: 0 for 1 to 9
  if (first < -4 || first >= 16) {
    to = count == 1 ? write_digits(to, decimal.digits, 1)
                    : write_fraction(to, decimal.digits, count, 1);
    return write_exponent(to, first);
  }
  if (decimal.exponent >= 0) {
    return write_zeros(write_digits(to, decimal.digits, count), decimal.exponent);
  }
  if (first >= 0) return write_fraction(to, decimal.digits, count, first + 1);
  to = write_zeros(write_text(to, "0."), -first - 1);
  return write_digits(to, decimal.digits, count);
}

template <typename Real>
char* write_real(char* to, Real value) {
  if (std::signbit(value)) {
    *to++ = '-';
    value = -value;
  }
  if (!std::isfinite(value)) return write_text(to, std::isnan(value) ? "nan" : "inf");
  if (value == 0) return write_text(to, "0");
  return write_decimal(to, shortest_decimal(value));
}

}  // namespace

char* write_number(char* to, std::uint64_t value) {
  return write_digits(to, value, count_digits(value));
}

char* write_number(char* to, std::int64_t value) {
  if (value >= 0) return write_number(to, static_cast<std::uint64_t>(value));
  *to = '-';
  return write_number(to + 1, -static_cast<std::uint64_t>(value));
}

char* write_number(char* to, double value) { return write_real(to, value); }
char* write_number(char* to, float value) { return write_real(to, value); }

}  // namespace kdm
