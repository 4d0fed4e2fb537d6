// SPDX-License-Identifier: MIT
// Holds a result against its input.
#include "kdmanifold/account.h"

#include <algorithm>
#include <new>

#include "account/lost_area.h"
#include "account/measure_error.h"
#include "kdmanifold/error.h"
#include "text/compose.h"
#include "text/rounded.h"

namespace kdm {

namespace {

constexpr double kSmallShare = 0.001;

void warn(const LostArea& lost, std::vector<Warning>& warnings) {
  if (lost.share <= kSmallShare) return;
  warnings.push_back(
      {"AREA_LOST", compose("{} % of the input's area is missing from the result, in {} {}, the "
                            "largest with an area of {}",
                            rounded(100 * lost.share), lost.parts,
                            lost.parts == 1 ? "piece" : "pieces", rounded(lost.largest))});
}

// Tells of places that are far apart, where no warning tells that area is missing.
void warn(const MeshError& error, const BothSurfaces& both, double tolerance,
          std::vector<Warning>& warnings) {
  const double allowed = both.allowed * both.unit;
  const bool input_is_far = error.to_output.largest > allowed && warnings.empty();
  // Where holes are closed, the result leaves the input.
  const bool result_is_far = both.input_tells() && error.to_input.largest > allowed;
  if (!input_is_far && !result_is_far) return;
  const double furthest = std::max(input_is_far ? error.to_output.largest : 0,
                                   result_is_far ? error.to_input.largest : 0);
  warnings.push_back(
      {"FAR_FROM_INPUT", compose("the result is up to {} from the input: the tolerance was {}",
                                 rounded(furthest), rounded(tolerance))});
}

}  // namespace

Account compare(const Mesh& input, const Grid& grid, const Mesh& result,
                const CompareOptions& options) try {
  BothSurfaces both(input, grid.data(), result);
  Account account;
  account.lost = find_lost_area(both);
  warn(account.lost, account.warnings);
  if (options.error) {
    account.error = measure_error(both);
    warn(*account.error, both, grid.stats().tolerance, account.warnings);
  }
  return account;
} catch (const std::bad_alloc&) {
  throw Error(ErrorCode::kOutOfMemory, "there is not enough memory to compare the surfaces");
}

}  // namespace kdm
