// SPDX-License-Identifier: MIT
// Says which part of a mesh a pass looks at.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "mesh/numbers.h"

namespace kdm {

/// Stands for everything, or for the numbers in a list. The pass defines whether these are hits,
/// vertices or triangles. A pass looks at them in the order of the list. Refers to the list, which
/// must outlive it.
class Scope {
 public:
  /// Makes the scope of everything.
  Scope() = default;
  /// Makes the scope of a list, which may be empty.
  Scope(const std::vector<Index>& numbers) : all_(false), numbers_(numbers) {}
  Scope(std::vector<Index>&&) = delete;

  bool is_all() const { return all_; }
  std::span<const Index> numbers() const { return numbers_; }
  /// Returns whether the number is in the scope. The numbers of the list must ascend. Takes
  /// logarithmic time.
  bool contains(Index number) const {
    return all_ || std::binary_search(numbers_.begin(), numbers_.end(), number);
  }
  /// Calls `visit(number)` for each number of the list, or for all numbers below `count`.
  template <typename Visit>
  void for_each(Index count, const Visit& visit) const {
    if (all_) {
      for (Index i = 0; i < count; ++i) visit(i);
    } else {
      for (const Index i : numbers_) visit(i);
    }
  }

 private:
  bool all_ = true;
  std::span<const Index> numbers_;
};

}  // namespace kdm
