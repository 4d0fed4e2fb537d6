// SPDX-License-Identifier: MIT
// Limits the effort for surfaces to which no number of splits brings the result within the
// tolerance.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

namespace kdm {

/// How many splits, and how much work on winding numbers, one attempt to construct the cells may
/// take. A surface that is to be repaired may cross itself and end everywhere; then no tolerance is
/// met, and winding numbers take long. An attempt that goes beyond its budget is given up, and the
/// next one has a wider tolerance.
class Budget {
 public:
  /// Makes a budget without limits.
  Budget() = default;

  /// Makes the budget for a surface to be repaired. `work` is the value of InsideModel::work when
  /// the attempt begins; only work beyond it counts. The limits were found by trial: they are above
  /// what was needed by any model whose result gained by the effort; models that need more only
  /// reproduce the disorder of their surface.
  static Budget for_repair(std::size_t triangles, std::size_t work) {
    constexpr std::size_t kSplits = 300000;
    constexpr std::size_t kSplitsPerTriangle = 32;
    constexpr std::size_t kWork = 40000000;
    constexpr std::size_t kWorkPerTriangle = 64;
    Budget budget;
    budget.splits_left_ = kSplits + kSplitsPerTriangle * triangles;
    budget.most_work_ = work + kWork + kWorkPerTriangle * triangles;
    return budget;
  }

  void take_split() { --splits_left_; }

  /// Takes several splits, unless that would reach the limit. Returns whether it did.
  bool take_splits(std::size_t splits) {
    if (splits >= splits_left_) return false;
    splits_left_ -= splits;
    return true;
  }

  /// Returns whether a limit is reached, and from then on always. `done` is the fraction (0 to 1)
  /// of the construction that is done at this point.
  bool exceeded(std::size_t work, double done) {
    if (splits_left_ > 0 && work < most_work_) return false;
    splits_left_ = 0;
    done_ = std::min(done_, done);
    return true;
  }

  /// Returns whether no limit was reached.
  bool sufficed() const { return splits_left_ > 0; }
  /// Returns the fraction of the construction that was done when a limit was reached; 1 if none
  /// was.
  double done() const { return done_; }

 private:
  std::size_t splits_left_ = std::numeric_limits<std::size_t>::max();
  std::size_t most_work_ = std::numeric_limits<std::size_t>::max();
  double done_ = 1;
};

}  // namespace kdm
