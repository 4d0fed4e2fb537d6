// SPDX-License-Identifier: MIT
// Each thing worth a warning is told, in words with numbers, and nothing else is.
#include "extract/warnings.h"

#include <gtest/gtest.h>

#include "kdmanifold/build.h"
#include "kdmanifold/error.h"
#include "support/shapes.h"

namespace kdm {
namespace {

std::vector<std::string> codes_of(const std::vector<Warning>& warnings) {
  std::vector<std::string> codes;
  for (const Warning& warning : warnings) codes.push_back(warning.code);
  return codes;
}

TEST(Warnings, ThereAreNoneWhereNothingHappened) {
  EXPECT_TRUE(collect_warnings({}, {}, {}, 1).empty());
}

TEST(Warnings, TellLossesFirst) {
  InputReport input;
  input.lost_parts = 2;
  input.lost_area = 12.3456;
  input.largest_lost = 10;
  input.turned_parts = 1;
  GridStats grid;
  grid.unresolved_leaves = 1;
  const std::vector<Warning> warnings = collect_warnings(input, grid, {}, 100);
  EXPECT_EQ(codes_of(warnings),
            (std::vector<std::string>{"PARTS_LOST", "TOPOLOGY_UNRESOLVED", "PARTS_TURNED"}));
  EXPECT_EQ(warnings[0].message,
            "parts of the input that bound nothing were left out: 2, an area of 12.3, the largest "
            "10; thicken keeps them");
  EXPECT_NE(warnings[1].message.find("given up in 1 cell:"), std::string::npos);
  EXPECT_EQ(warnings[2].message, "closed parts that were inside out were turned: 1");
}

TEST(Warnings, TellThatTheToleranceWasWidened) {
  GridStats grid;
  grid.asked_tolerance = 0.001;
  grid.tolerance = 0.001000001;  // rounding
  EXPECT_TRUE(collect_warnings({}, grid, {}, 1).empty());
  grid.tolerance = 0.0163;
  const std::vector<Warning> warnings = collect_warnings({}, grid, {}, 1);
  ASSERT_EQ(codes_of(warnings), std::vector<std::string>{"TOLERANCE_WIDENED"});
  EXPECT_NE(warnings[0].message.find("from 0.001 to 0.0163"), std::string::npos);
}

TEST(Warnings, TellWhatIsNew) {
  ExtractReport report;
  report.invented_area = 1;
  GridStats grid;
  grid.winding_threshold = 0.4;
  const std::vector<Warning> warnings = collect_warnings({}, grid, report, 3);
  ASSERT_EQ(codes_of(warnings), (std::vector<std::string>{"HOLES_CLOSED", "WINDING_THRESHOLD"}));
  EXPECT_EQ(warnings[0].message, "holes were closed: 33.3 % of the result's area is new");
}

}  // namespace
}  // namespace kdm
