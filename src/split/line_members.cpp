// SPDX-License-Identifier: MIT
#include "split/line_members.h"

#include <algorithm>
#include <cmath>

namespace kdm {
namespace {

constexpr std::int64_t kMostColumns = 16;  // along an axis

}  // namespace

template <typename Visit>
void LineMembers::for_each_column(const LatticeBox& bounds, const Visit& visit) const {
  const std::size_t last_0 = column_of(bounds.hi[0], 0);
  const std::size_t last_1 = column_of(bounds.hi[1], 1);
  for (std::size_t i = column_of(bounds.lo[0], 0); i <= last_0; ++i) {
    for (std::size_t j = column_of(bounds.lo[1], 1); j <= last_1; ++j) visit(i * columns_ + j);
  }
}

void LineMembers::list(const CellTriangles& cell) {
  box_ = cell.cell();
  for (std::vector<MemberId>& members : on_first_) members.clear();
  for (MemberId m = 0; m < cell.size(); ++m) {
    const LatticeBox& bounds = cell.bounds(m);
    if (bounds.lo[2] > box_.lo[2]) continue;
    on_first_[1].push_back(m);
    if (bounds.lo[1] <= box_.lo[1]) on_first_[0].push_back(m);
  }
  columns_ =
      std::clamp(static_cast<std::int64_t>(std::sqrt(cell.size())), std::int64_t{1}, kMostColumns);
  first_.assign(columns_ * columns_ + 1, 0);
  for (MemberId m = 0; m < cell.size(); ++m) {
    for_each_column(cell.bounds(m), [&](std::size_t column) { ++first_[column]; });
  }
  Index end = 0;
  for (Index& first : first_) first = end += first;
  in_columns_.resize(end);
  for (MemberId m = cell.size(); m-- > 0;) {
    for_each_column(cell.bounds(m), [&](std::size_t column) { in_columns_[--first_[column]] = m; });
  }
}

}  // namespace kdm
