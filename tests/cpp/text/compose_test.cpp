// SPDX-License-Identifier: MIT
#include "text/compose.h"

#include <gtest/gtest.h>

#include <string>

namespace kdm {
namespace {

TEST(Compose, PutsValuesInTheirPlaces) {
  const std::string name = "depth";
  EXPECT_EQ(compose("nothing"), "nothing");
  EXPECT_EQ(compose("{}", 7), "7");
  EXPECT_EQ(compose("{} is {}; it must be {}", name, 0.5, "a whole number"),
            "depth is 0.5; it must be a whole number");
  EXPECT_EQ(compose("({}, {})", -1.5f, std::string_view(name).substr(1, 2)), "(-1.5, ep)");
  EXPECT_EQ(compose("{}{}", 'x', std::size_t{12}), "x12");
}

TEST(Compose, ValuesAreNoPatterns) {
  EXPECT_EQ(compose("{} and {}", "{}", "b"), "{} and b");
  EXPECT_EQ(compose("{ {} }", 1), "{ 1 }");
}

}  // namespace
}  // namespace kdm
