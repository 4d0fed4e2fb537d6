// SPDX-License-Identifier: MIT
// Sorts in little code: the standard library makes two to five kilobytes of each pair of an element
// and an order, and a page has to fetch them all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

/// Sort numbers.
void sort_numbers(std::span<Index> numbers);
void sort_numbers(std::span<std::uint64_t> numbers);

/// Sorts numbers and keeps one of those that are equal.
void make_set(std::vector<Index>& numbers);

/// A pair as one number, which goes by the first, then by the second: the quickest to sort.
constexpr std::uint64_t pack_pair(std::int32_t first, std::uint32_t second) {
  return std::uint64_t{static_cast<std::uint32_t>(first) ^ 0x80000000u} << 32 | second;
}
constexpr std::int32_t first_of_pair(std::uint64_t pair) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(pair >> 32) ^ 0x80000000u);
}
constexpr std::uint32_t second_of_pair(std::uint64_t pair) {
  return static_cast<std::uint32_t>(pair);
}

/// Says whether the element with one number goes before the one with another.
class Order {
 public:
  /// `before(a, b)` must outlive this.
  template <typename Before>
  explicit Order(const Before& before)
      : before_(&before), call_([](const void* function, Index a, Index b) {
          return (*static_cast<const Before*>(function))(a, b);
        }) {}

  bool operator()(Index a, Index b) const { return call_(before_, a, b); }

 private:
  const void* before_;
  bool (*call_)(const void*, Index, Index);
};

/// Returns the numbers from 0 to `count` - 1 in their order; equal elements by their numbers.
std::vector<Index> in_order(std::size_t count, const Order& order);

/// Sorts by `less`; equal elements keep their order. Quick for short ranges: longer ones take a
/// copy and call `less` through a pointer.
template <typename Range, typename Less>
void sort_by(Range&& range, const Less& less) {
  const std::span elements(range);
  using Element = typename decltype(elements)::element_type;
  constexpr std::size_t kShort = 24;
  if (elements.size() <= kShort) {
    for (std::size_t i = 1; i < elements.size(); ++i) {
      std::size_t place = i;
      const Element inserted = elements[i];
      for (; place > 0 && less(inserted, elements[place - 1]); --place) {
        elements[place] = elements[place - 1];
      }
      elements[place] = inserted;
    }
    return;
  }
  const auto before = [&](Index a, Index b) { return less(elements[a], elements[b]); };
  const std::vector<Index> order = in_order(elements.size(), Order(before));
  const std::vector<Element> copy(elements.begin(), elements.end());
  for (std::size_t i = 0; i < order.size(); ++i) elements[i] = copy[order[i]];
}

/// Sorts by the elements' own order.
template <typename Range>
void sort_up(Range&& range) {
  sort_by(range, [](const auto& a, const auto& b) { return a < b; });
}

}  // namespace kdm
