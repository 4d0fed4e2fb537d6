// SPDX-License-Identifier: MIT
// Holds the wish to reduce against what excludes it.
#include "make/reduction_rule.h"

#include "kdmanifold/error.h"
#include "kdmanifold/options.h"
#include "text/compose.h"

namespace kdm {
namespace {

// What excludes reduction, with names of options in backticks; null if nothing does.
const char* obstacle_in(const ExtractOptions& extract) {
  if (extract.quads) return "`quads`";
  if (extract.strict == Strict::kOff) return "`strict` off";
  return nullptr;
}

const char* obstacle_in(const BuildOptions& build) {
  if (build.strategy == SplitStrategy::kMedian) return "`strategy` median";
  if (build.strategy == SplitStrategy::kUniform) return "`strategy` uniform";
  if (build.cells > 0) return "`cells`";
  if (build.tolerance == 0 && build.relative_tolerance == 0) return "`relative_tolerance` 0";
  return nullptr;
}

[[noreturn]] void refuse(const char* name, const char* obstacle) {
  throw Error(ErrorCode::kInvalidOption, compose("`{}`: not together with {}", name, obstacle));
}

// The option that asks for reduction; null if none does.
const char* wish_in(const ReductionOptions& reduction) {
  const char* const special = !reduction.target_triangles.empty() ? "target_triangles"
                              : !reduction.keep_groups.empty()    ? "keep_groups"
                                                                  : nullptr;
  if (special != nullptr) {
    if (!reduction.reduce.value_or(true)) refuse(special, "`reduce` false");
    return special;
  }
  return reduction.reduce.value_or(false) ? "reduce" : nullptr;
}

// Decides between a wish, an obstacle and what is done if there is neither.
bool decide(const ReductionOptions& reduction, const char* obstacle, bool standard) {
  const char* const wish = wish_in(reduction);
  if (wish != nullptr && obstacle != nullptr) refuse(wish, obstacle);
  return wish != nullptr || (obstacle == nullptr && reduction.reduce.value_or(standard));
}

// Says whether a part of the tolerance that was asked for is left.
bool is_built_for_reduction(const GridStats& grid) {
  constexpr double kRounding = 0.01;
  return grid.asked_tolerance > 0 &&
         grid.tolerance < (kGridShare + kRounding) * grid.asked_tolerance &&
         grid.tolerance > (kGridShare - kRounding) * grid.asked_tolerance;
}

}  // namespace

bool reduces(const MakeOptions& options) {
  check_options(options.build);
  check_options(options.extract);
  check_options(options.reduction);
  const char* const of_extract = obstacle_in(options.extract);
  return decide(options.reduction, of_extract != nullptr ? of_extract : obstacle_in(options.build),
                true);
}

bool reduces(const GridStats& grid, const ExtractOptions& extract,
             const ReductionOptions& reduction) {
  check_options(extract);
  check_options(reduction);
  return decide(reduction, obstacle_in(extract), is_built_for_reduction(grid));
}

void check_reducible(const ExtractOptions& extract, const char* asked) {
  if (const char* const obstacle = obstacle_in(extract)) refuse(asked, obstacle);
}

}  // namespace kdm
