// SPDX-License-Identifier: MIT
#include "split/line_members.h"

#include <algorithm>
#include <cmath>

namespace kdm {
namespace {

constexpr std::size_t kMostColumns = 16;  // along an axis

}  // namespace

template <typename Visit>
void LineMembers::for_each_strip(const LatticeBox& bounds, const Visit& visit) const {
  const std::size_t last = column_of(bounds.hi[0], 0);
  for (std::size_t i = column_of(bounds.lo[0], 0); i <= last; ++i) visit(i);
}

template <typename Visit>
void LineMembers::for_each_column(const LatticeBox& bounds, const Visit& visit) const {
  const std::size_t last_0 = column_of(bounds.hi[0], 0);
  const std::size_t last_1 = column_of(bounds.hi[1], 1);
  for (std::size_t i = column_of(bounds.lo[0], 0); i <= last_0; ++i) {
    for (std::size_t j = column_of(bounds.lo[1], 1); j <= last_1; ++j) visit(i * columns_ + j);
  }
}

// `for_each_place(member, visit)` visits the places that a member is to be listed for.
template <typename ForEachPlace>
void LineMembers::Lists::fill(std::size_t places, Index members,
                              const ForEachPlace& for_each_place) {
  first.assign(places + 1, 0);
  for (MemberId m = 0; m < members; ++m) {
    for_each_place(m, [&](std::size_t place) { ++first[place]; });
  }
  Index end = 0;
  for (Index& number : first) number = end += number;
  all.resize(end);
  for (MemberId m = members; m-- > 0;) {
    for_each_place(m, [&](std::size_t place) { all[--first[place]] = m; });
  }
}

void LineMembers::list(const CellTriangles& cell) {
  box_ = cell.cell();
  on_first_edge_.clear();
  for (MemberId m = 0; m < cell.size(); ++m) {
    const LatticeBox& bounds = cell.bounds(m);
    if (bounds.lo[2] <= box_.lo[2] && bounds.lo[1] <= box_.lo[1]) on_first_edge_.push_back(m);
  }
  columns_ =
      std::clamp(static_cast<std::size_t>(std::sqrt(cell.size())), std::size_t{1}, kMostColumns);
  in_strips_.fill(columns_, cell.size(), [&](MemberId m, const auto& visit) {
    if (cell.bounds(m).lo[2] <= box_.lo[2]) for_each_strip(cell.bounds(m), visit);
  });
  in_columns_.fill(columns_ * columns_, cell.size(),
                   [&](MemberId m, const auto& visit) { for_each_column(cell.bounds(m), visit); });
}

}  // namespace kdm
