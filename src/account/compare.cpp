// SPDX-License-Identifier: MIT
// Holds a result against its input.
#include "kdmanifold/account.h"

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

}  // namespace

Account compare(const Mesh& input, const Grid& grid, const Mesh& result,
                const CompareOptions& options) try {
  BothSurfaces both(input, grid.data(), result);
  Account account;
  account.lost = find_lost_area(both);
  warn(account.lost, account.warnings);
  if (options.error) account.error = measure_error(both);
  return account;
} catch (const std::bad_alloc&) {
  throw Error(ErrorCode::kOutOfMemory, "there is not enough memory to compare the surfaces");
}

}  // namespace kdm
