// SPDX-License-Identifier: MIT
#include "mesh/progress.h"

#include <gtest/gtest.h>

#include <string>

namespace kdm {
namespace {

TEST(ReportProgress, TellsFractionAndPhase) {
  double fraction = -1;
  std::string phase;
  const Progress progress = [&](double f, std::string_view p) {
    fraction = f;
    phase = p;
    return true;
  };
  report_progress(progress, 0.25, "build");
  EXPECT_EQ(fraction, 0.25);
  EXPECT_EQ(phase, "build");
  report_progress({}, 0.5, "link");  // nobody listens
}

TEST(ReportProgress, ThrowsWhereTheCallerAsksToStop) {
  const Progress stop = [](double, std::string_view) { return false; };
  try {
    report_progress(stop, 0, "build");
    FAIL() << "it went on";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kAborted);
  }
}

TEST(PartOfProgress, LiesWithinTheWhole) {
  double shown = -1;
  bool go_on = true;
  const Progress whole = [&](double fraction, std::string_view) {
    shown = fraction;
    return go_on;
  };
  const Progress part = part_of_progress(whole, 0.25, 0.75);
  EXPECT_TRUE(part(0, "build"));
  EXPECT_EQ(shown, 0.25);
  EXPECT_TRUE(part(0.5, "build"));
  EXPECT_EQ(shown, 0.5);
  EXPECT_TRUE(part(1, "build"));
  EXPECT_EQ(shown, 0.75);
  go_on = false;
  EXPECT_FALSE(part(1, "build"));
  EXPECT_FALSE(part_of_progress({}, 0, 1));
}

}  // namespace
}  // namespace kdm
