// SPDX-License-Identifier: MIT
#include "merge/merge_rule.h"

namespace kdm {

std::optional<Split> MergeRule::choose(const CellView& cell) {
  std::array<CellId, 2> node;
  int with_surface = 0;
  for (int i = 0; i < 2; ++i) {
    node[i] = cell_around(solids_[i]->grid(), cell.box);
    if (solids_[i]->has_surface(node[i])) with_surface |= 1 << i;
  }
  if (!function_.depends_on(with_surface, cell.state)) return std::nullopt;
  if (cell.depth == kMaxDepth) {
    ++joined_leaves_;
    return std::nullopt;
  }
  std::array<std::optional<Split>, 2> splits;
  for (int i = 0; i < 2; ++i) {
    if ((with_surface >> i & 1) != 0) splits[i] = split_of(i, node[i]);
  }
  if (splits[0] && splits[1]) {
    const Index cut_by_first =
        solids_[1]->count_cut(node[1], cell.box, splits[0]->axis, splits[0]->value);
    const Index cut_by_second =
        solids_[0]->count_cut(node[0], cell.box, splits[1]->axis, splits[1]->value);
    return cut_by_second < cut_by_first ? splits[1] : splits[0];
  }
  if (splits[0]) return splits[0];
  if (splits[1]) return splits[1];
  const bool both = with_surface == 3;
  if (both ? same_in_both(node)
           : cell.box == solids_[with_surface - 1]->boxes()[node[with_surface - 1]]) {
    return std::nullopt;
  }
  const double diagonal = (to_vec3(cell.box.hi) - to_vec3(cell.box.lo)).norm();
  std::optional<Split> split;
  if (diagonal > tolerance_) split = adaptive_->choose(cell);
  if (!split) ++joined_leaves_;
  return split;
}

std::optional<Split> MergeRule::split_of(int solid, CellId node) const {
  const Cell& cell = solids_[solid]->grid().cells[node];
  if (cell.leaf()) return std::nullopt;
  return Split{cell.axis(), cell.value()};
}

// Tells whether two leaves are one and the same, with the same surface.
bool MergeRule::same_in_both(const std::array<CellId, 2>& leaves) const {
  if (solids_[0]->boxes()[leaves[0]] != solids_[1]->boxes()[leaves[1]]) return false;
  const std::span<const Index> a = solids_[0]->triangles_in(leaves[0]);
  const std::span<const Index> b = solids_[1]->triangles_in(leaves[1]);
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (solids_[0]->triangle(a[i]) != solids_[1]->triangle(b[i])) return false;
  }
  return true;
}

}  // namespace kdm
