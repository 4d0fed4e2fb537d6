// SPDX-License-Identifier: MIT
// One flag for each number of a range: which triangles, vertices or sides have some property.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace kdm {

/// Holds one flag for each number below `size()`. A flag takes a byte, because reading a byte takes
/// one load where a bit takes a load, a shift and a mask.
class Marks {
 public:
  Marks() = default;
  /// Makes `size` flags, all unmarked.
  explicit Marks(std::size_t size) : flags_(size, 0) {}

  /// Makes `size` flags, all unmarked; the flags that there were are lost.
  void assign(std::size_t size) { flags_.assign(size, 0); }
  /// Keeps the flags below `size`; flags that are added are unmarked.
  void resize(std::size_t size) { flags_.resize(size, 0); }
  void reserve(std::size_t size) { flags_.reserve(size); }
  /// Adds a flag behind the last one.
  void push_back(bool marked) { flags_.push_back(marked ? 1 : 0); }

  bool test(std::size_t number) const { return flags_[number] != 0; }
  void set(std::size_t number) { flags_[number] = 1; }
  void set(std::size_t number, bool marked) { flags_[number] = marked ? 1 : 0; }
  void clear(std::size_t number) { flags_[number] = 0; }
  /// Marks the number and returns whether it was marked before.
  bool test_and_set(std::size_t number) {
    const bool marked = flags_[number] != 0;
    flags_[number] = 1;
    return marked;
  }
  /// Unmarks every number; takes time linear in `size()`.
  void clear_all() { std::fill(flags_.begin(), flags_.end(), char{0}); }

  std::size_t size() const { return flags_.size(); }
  bool empty() const { return flags_.empty(); }
  /// Counts the numbers that are marked, in time linear in `size()`.
  std::size_t count() const {
    return static_cast<std::size_t>(std::count(flags_.begin(), flags_.end(), char{1}));
  }
  /// Whether one number at least is marked.
  bool any() const { return std::find(flags_.begin(), flags_.end(), char{1}) != flags_.end(); }

  bool operator==(const Marks&) const = default;

 private:
  std::vector<char> flags_;
};

}  // namespace kdm
