// SPDX-License-Identifier: MIT
#include "text/numbers.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace kdm {
namespace {

template <typename Number>
std::string text(Number value) {
  char to[kLongestNumber];
  return {to, write_number(to, value)};
}

TEST(Numbers, WholeNumbers) {
  EXPECT_EQ(text(0), "0");
  EXPECT_EQ(text(-7), "-7");
  std::string digits;
  std::uint64_t value = 0;
  for (int i = 1; i <= 19; ++i) {
    digits += static_cast<char>('0' + i % 10);
    value = value * 10 + static_cast<std::uint64_t>(i % 10);
    EXPECT_EQ(text(value), digits);
  }
  for (std::uint64_t power = 1, zeros = 0; zeros < 20; power *= 10, ++zeros) {
    EXPECT_EQ(text(power), '1' + std::string(zeros, '0'));
    EXPECT_EQ(text(power - 1), zeros == 0 ? "0" : std::string(zeros, '9'));
  }
  EXPECT_EQ(text(std::numeric_limits<std::uint32_t>::max()), "4294967295");
  EXPECT_EQ(text(std::numeric_limits<std::uint64_t>::max()), "18446744073709551615");
  EXPECT_EQ(text(std::numeric_limits<std::int64_t>::min()), "-9223372036854775808");
}

TEST(Numbers, Fractions) {
  EXPECT_EQ(text(0.0), "0");
  EXPECT_EQ(text(-0.0), "-0");
  EXPECT_EQ(text(1.0), "1");
  EXPECT_EQ(text(0.1), "0.1");
  EXPECT_EQ(text(0.1f), "0.1");
  EXPECT_EQ(text(double{0.1f}), "0.10000000149011612");
  EXPECT_EQ(text(-12.5), "-12.5");
  EXPECT_EQ(text(1200.0), "1200");
  EXPECT_EQ(text(123456.789), "123456.789");
}

TEST(Numbers, ExponentsBeginWhereZerosWouldBeMany) {
  EXPECT_EQ(text(0.0001), "0.0001");
  EXPECT_EQ(text(0.00012345678901234567), "0.00012345678901234567");
  EXPECT_EQ(text(0.00001), "1e-05");
  EXPECT_EQ(text(0.000015), "1.5e-05");
  EXPECT_EQ(text(1e15), "1000000000000000");
  EXPECT_EQ(text(1e16), "1e+16");
  EXPECT_EQ(text(1.5e16f), "1.5e+16");
  EXPECT_EQ(text(1e150), "1e+150");
}

TEST(Numbers, EndsOfTheRange) {
  EXPECT_EQ(text(-std::numeric_limits<double>::min()), "-2.2250738585072014e-308");
  EXPECT_EQ(text(std::numeric_limits<double>::max()), "1.7976931348623157e+308");
  EXPECT_EQ(text(std::numeric_limits<double>::denorm_min()), "5e-324");
  EXPECT_EQ(text(std::numeric_limits<float>::max()), "3.4028235e+38");
  EXPECT_EQ(text(std::numeric_limits<float>::denorm_min()), "1e-45");
  EXPECT_EQ(text(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(text(-std::numeric_limits<float>::infinity()), "-inf");
  EXPECT_EQ(text(std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(text(-std::numeric_limits<double>::quiet_NaN()), "-nan");
}

}  // namespace
}  // namespace kdm
