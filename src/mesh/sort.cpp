// SPDX-License-Identifier: MIT
#include "mesh/sort.h"

#include <algorithm>
#include <numeric>

namespace kdm {

void sort_numbers(std::span<Index> numbers) {
  std::sort(numbers.data(), numbers.data() + numbers.size());
}
void sort_numbers(std::span<std::uint64_t> numbers) {
  std::sort(numbers.data(), numbers.data() + numbers.size());
}

void make_set(std::vector<Index>& numbers) {
  sort_numbers(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

// Merges runs of 1, 2, 4, ... numbers, to and fro between two arrays.
std::vector<Index> in_order(std::size_t count, const Order& order) {
  std::vector<Index> from(count);
  std::iota(from.begin(), from.end(), Index{0});
  std::vector<Index> to(count);
  for (std::size_t run = 1; run < count; run *= 2) {
    for (std::size_t begin = 0; begin < count; begin += 2 * run) {
      const std::size_t middle = std::min(begin + run, count);
      const std::size_t end = std::min(middle + run, count);
      std::size_t a = begin;
      std::size_t b = middle;
      for (std::size_t i = begin; i < end; ++i) {
        const bool second = a == middle || (b < end && order(from[b], from[a]));
        to[i] = from[second ? b++ : a++];
      }
    }
    from.swap(to);
  }
  return from;
}

}  // namespace kdm
