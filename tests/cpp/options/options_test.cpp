// SPDX-License-Identifier: MIT
// The tables of options and reports: every member is in them, names and ranges are as promised, and
// the library checks by them.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "kdmanifold/kdmanifold.h"
#include "kdmanifold/options.h"
#include "kdmanifold/reports.h"
#include "support/shapes.h"

namespace kdm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The bytes of an object that the table reaches; counted from the start of the struct, gaps for
// alignment left out at most 7 at a time.
template <typename Struct>
void expect_all_members_listed(const auto... of_faces) {
  const Struct object{};
  const char* const start = reinterpret_cast<const char*>(&object);
  std::size_t covered = 0;
  std::set<std::string> names;
  std::vector<bool> reached(sizeof(Struct));
  const auto reach = [&](const auto& member) {
    const char* const at = reinterpret_cast<const char*>(&member);
    for (std::size_t i = 0; i < sizeof(member); ++i) reached[at - start + i] = true;
  };
  (reach(object.*of_faces), ...);
  for_each_field(object, [&](const auto& field, const auto& member) {
    EXPECT_TRUE(names.insert(field.name).second) << field.name << " is listed twice";
    const char* const at = reinterpret_cast<const char*>(&member);
    if (at < start || at >= start + sizeof(Struct)) return;  // handed out as another type
    reach(member);
  });
  for (std::size_t i = 0, run = 0; i < sizeof(Struct); ++i) {
    run = reached[i] ? 0 : run + 1;
    EXPECT_LT(run, 8u) << "bytes up to " << i << " belong to a member that is not listed";
    covered += reached[i];
  }
  EXPECT_GT(covered, 0u);
}

TEST(Options, EveryMemberIsListed) {
  expect_all_members_listed<BuildOptions>();
  expect_all_members_listed<ExtractOptions>();
  expect_all_members_listed<ReductionOptions>(&ReductionOptions::keep_groups);
  expect_all_members_listed<ReduceOptions>(&ReduceOptions::keep_groups);
  expect_all_members_listed<AnalyzeOptions>();
}

TEST(Reports, EveryMemberIsListed) {
  expect_all_members_listed<InputReport>();
  expect_all_members_listed<GridStats>();
  expect_all_members_listed<ExtractReport>();
  expect_all_members_listed<ReduceReport>();
  expect_all_members_listed<MeshReport>();
  expect_all_members_listed<SelfIntersections>();
  expect_all_members_listed<MeshDefects>();
  expect_all_members_listed<LostArea>();
  expect_all_members_listed<MeshError>();
  expect_all_members_listed<Deviation>();
}

TEST(Options, NamesAndRangesAreWrittenAsUsersReadThem) {
  EXPECT_EQ(camel_case("relative_tolerance"), "relativeTolerance");
  EXPECT_EQ(camel_case("depth"), "depth");
  EXPECT_EQ(kebab_case("relative_tolerance"), "relative-tolerance");
  EXPECT_EQ(range_text({}), "from 0 on");
  EXPECT_EQ(range_text({.least = 1, .most = 60}), "from 1 to 60");
  EXPECT_EQ(range_text({.most = 1, .most_excluded = true}), "from 0 to below 1");
  EXPECT_EQ(joined_words<Parts>("|"), "all|outer|largest");
  EXPECT_EQ(value_of<Strict>("embedded"), Strict::kEmbedded);
  EXPECT_EQ(value_of<Strict>("loose"), std::nullopt);
}

TEST(Options, DefaultsAreLegal) {
  EXPECT_NO_THROW(check_options(BuildOptions{}));
  EXPECT_NO_THROW(check_options(ExtractOptions{}));
  EXPECT_NO_THROW(check_options(ReductionOptions{}));
}

template <typename Options>
std::string complaint(const Options& options) {
  try {
    check_options(options);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kInvalidOption);
    return error.what();
  }
  return "";
}

// Sets one field after the other to values that are legal and to others that are not.
template <typename Options>
void expect_ranges_checked(Options options = {}) {
  if constexpr (std::is_same_v<Options, ExtractOptions>) options.normals = true;  // for the angle
  for_each_field(options, [&](const OptionField& field, auto& member) {
    using Value = std::decay_t<decltype(member)>;
    const Value standard = member;
    if constexpr (std::is_same_v<Options, BuildOptions>) {
      if constexpr (std::is_same_v<Value, ThickenWhat>) options.thicken = 1;  // or it has no effect
      if (std::string_view(field.name) == "cells") {
        options.strategy = SplitStrategy::kOctree;  // likewise
      }
    }
    if constexpr (std::is_enum_v<Value>) {
      for (const Word<Value>& word : words_of<Value>()) {
        member = word.value;
        EXPECT_EQ(complaint(options), "") << word.word;
      }
      member = static_cast<Value>(99);
      EXPECT_EQ(complaint(options).rfind(std::string(field.name) + " is 99", 0), 0u);
    } else if constexpr (std::is_same_v<Value, std::vector<Index>>) {
      for (const Value& legal : {Value{}, Value{1}, Value{5, 4, 1}}) {
        member = legal;
        EXPECT_EQ(complaint(options), "") << field.name;
      }
      for (const Value& wrong : {Value{0}, Value{5, 5}, Value{4, 5}}) {
        member = wrong;
        EXPECT_EQ(complaint(options).rfind(std::string(field.name) + " is ", 0), 0u);
      }
    } else if constexpr (std::is_same_v<Value, std::optional<BoxCorners>>) {
      for (const BoxCorners& legal : {BoxCorners{0, 0, 0, 1, 1, 1}, BoxCorners{0, 0, 0, 0, 0, 1}}) {
        member = legal;
        EXPECT_EQ(complaint(options), "") << field.name;
      }
      for (const BoxCorners& wrong :
           {BoxCorners{}, BoxCorners{1, 1, 1, 0, 2, 2}, BoxCorners{0, 0, 0, 1, 1, kInfinity}}) {
        member = wrong;
        EXPECT_EQ(complaint(options).rfind(std::string(field.name) + ": ", 0), 0u);
      }
    } else if constexpr (std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>) {
      member = static_cast<Value>(field.range.least);
      EXPECT_EQ(complaint(options), "") << field.name;
      std::vector<double> wrong = {-1};
      if (has_end(field.range)) {
        const double most = field.range.most;
        member = static_cast<Value>(field.range.most_excluded ? most / 2 : most);
        EXPECT_EQ(complaint(options), "") << field.name;
        wrong.push_back(field.range.most_excluded ? most : most + 1);
      }
      if constexpr (std::is_same_v<Value, double>) {
        wrong.push_back(std::nan(""));
        if (field.range.most < kInfinity) wrong.push_back(kInfinity);
      }
      for (const double value : wrong) {
        member = static_cast<Value>(value);
        EXPECT_EQ(complaint(options).rfind(std::string(field.name) + " is ", 0), 0u) << value;
      }
    }
    member = standard;
  });
}

TEST(Options, RangesAreChecked) {
  expect_ranges_checked<BuildOptions>();
  expect_ranges_checked<ExtractOptions>();
  expect_ranges_checked<ReductionOptions>();
}

TEST(Options, MessagesSayWhatIsLegal) {
  EXPECT_EQ(complaint(BuildOptions{.depth = 61}),
            "depth is 61; it must be a whole number from 1 to 60, or 0, which stands for 60, or 18 "
            "for uniform, 64 cells an axis");
  EXPECT_EQ(complaint(BuildOptions{.winding_threshold = 1}),
            "winding_threshold is 1; it must be a number from 0 to below 1");
  EXPECT_EQ(complaint(ReductionOptions{.target_triangles = {7, 9}}),
            "target_triangles is 9; it must be a whole number from 1 on, smaller than the one "
            "before");
  EXPECT_EQ(complaint(ReduceOptions{}),
            "error is 0; it must be above 0, or target_triangles given");
  EXPECT_EQ(complaint(ExtractOptions{.link_error = -0.5}),
            "link_error is -0.5; it must be a number from 0 on");
}

TEST(Options, TheLibraryChecksThem) {
  EXPECT_THROW(build_grid(shapes::cube(), {.tolerance = -1}), Error);
  EXPECT_NO_THROW(build_grid(shapes::cube(), {.depth = 60}));
  const Grid grid = build_grid(shapes::cube());
  EXPECT_THROW(extract(grid, {.crease_angle = 181}), Error);
  EXPECT_NO_THROW(extract(grid, {.split_error = kInfinity, .link_error = kInfinity}));
}

std::string refusal(const auto& options) {
  try {
    check_options(options);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kInvalidOption);
    return error.what();
  }
  return "";
}

TEST(Options, CellsStandAlone) {
  EXPECT_EQ(complaint(BuildOptions{.strategy = SplitStrategy::kUniform, .cells = 500001}),
            "cells is 500001; it must be a whole number from 1 to 500000, or 0, which stands for "
            "what the depth and the tolerance say");
  EXPECT_EQ(refusal(BuildOptions{.cells = 80}), "`cells`: only with `strategy` octree or uniform");
  EXPECT_EQ(refusal(BuildOptions{.strategy = SplitStrategy::kMedian, .cells = 80}),
            "`cells`: only with `strategy` octree or uniform");
  EXPECT_EQ(refusal(BuildOptions{.strategy = SplitStrategy::kUniform, .depth = 9, .cells = 80}),
            "`depth`: not together with `cells`");
  EXPECT_EQ(refusal(BuildOptions{.strategy = SplitStrategy::kOctree, .tolerance = 1, .cells = 80}),
            "`tolerance`: not together with `cells`");
  EXPECT_EQ(refusal(BuildOptions{
                .strategy = SplitStrategy::kOctree, .relative_tolerance = 0.01, .cells = 80}),
            "`relative_tolerance`: not together with `cells`");
  EXPECT_EQ(refusal(BuildOptions{.strategy = SplitStrategy::kOctree, .cells = 80}), "");
}

TEST(Options, WhatHasNoEffectIsRefusedByName) {
  EXPECT_EQ(refusal(BuildOptions{.tolerance = 0.1, .relative_tolerance = 0.1}),
            "`relative_tolerance`: not together with `tolerance`");
  EXPECT_EQ(refusal(BuildOptions{.strategy = SplitStrategy::kUniform, .tolerance = 0.1}),
            "`tolerance`: only with `strategy` adaptive, octree or feature");
  EXPECT_EQ(refusal(BuildOptions{.strategy = SplitStrategy::kMedian, .relative_tolerance = 0.1}),
            "`relative_tolerance`: only with `strategy` adaptive, octree or feature");
  EXPECT_EQ(refusal(BuildOptions{.inside = InsideRule::kOdd, .winding_threshold = 0.1}),
            "`winding_threshold`: only with `inside` repair");
  EXPECT_EQ(refusal(BuildOptions{.inside = InsideRule::kSheet, .largest_hole = 0.1}),
            "`largest_hole`: only with `inside` repair");
  EXPECT_EQ(refusal(BuildOptions{.largest_hole = 0.1, .thicken = 0.1}),
            "`largest_hole`: not together with `thicken`, which leaves no holes");
  EXPECT_EQ(refusal(BuildOptions{.inside = InsideRule::kSheet, .pairing = Pairing::kOutside}),
            "`pairing`: only trace or hermite with `inside` sheet");
  EXPECT_EQ(refusal(BuildOptions{.thicken_what = ThickenWhat::kSheets}),
            "`thicken_what`: only with `thicken`");
  EXPECT_EQ(refusal(BuildOptions{
                .inside = InsideRule::kOdd, .thicken = 0.1, .thicken_what = ThickenWhat::kSheets}),
            "`thicken_what`: sheets only with `inside` repair");
  EXPECT_EQ(refusal(BuildOptions{
                .winding_threshold = 0.5, .thicken = 0.1, .thicken_what = ThickenWhat::kSheets}),
            "`thicken_what`: not sheets together with `winding_threshold`");
  EXPECT_EQ(refusal(ExtractOptions{.quads = true, .link_error = 1}),
            "`link_error`: not together with `quads`");
  EXPECT_EQ(refusal(ExtractOptions{.crease_angle = 20}), "`crease_angle`: only with `normals`");
  EXPECT_EQ(refusal(ReductionOptions{.remove_material = 1}),
            "`remove_material`: only with `simplify`");
  EXPECT_EQ(refusal(ReductionOptions{.add_material = 1}), "`add_material`: only with `simplify`");
  // Defaults do no harm.
  EXPECT_EQ(refusal(ReductionOptions{.simplify = 1, .remove_material = 1, .add_material = 1}), "");
  EXPECT_EQ(refusal(BuildOptions{.tolerance = 0.1, .relative_tolerance = 0.001}), "");
  EXPECT_EQ(refusal(ExtractOptions{.quads = true}), "");
  EXPECT_EQ(refusal(ExtractOptions{.quads = true, .strict = Strict::kManifold}), "");
  EXPECT_EQ(refusal(BuildOptions{
                .largest_hole = 0.1, .thicken = 0.1, .thicken_what = ThickenWhat::kSheets}),
            "");
  EXPECT_EQ(refusal(ExtractOptions{.normals = true, .crease_angle = 20}), "");
  const Grid sheet = build_grid(shapes::open(shapes::cube()), {.inside = InsideRule::kSheet});
  EXPECT_THROW(extract(sheet, {.parts = Parts::kLargest}), Error);
}

}  // namespace
}  // namespace kdm
