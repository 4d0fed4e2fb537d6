// SPDX-License-Identifier: MIT
// Joins triangles, and numbers what came of it.
#include "mesh/joined.h"

#include "mesh/sides.h"

namespace kdm {

DisjointSets join_triangles(std::span<const SideId> opposite) {
  DisjointSets sets(opposite.size() / 3);
  for (SideId side = 0; side < opposite.size(); ++side) {
    // Each pair of sides is looked at once; kNone is no lower one.
    if (opposite[side] < side) sets.join(triangle_of(side), triangle_of(opposite[side]));
  }
  return sets;
}

std::vector<Index> number_sets(DisjointSets& sets, std::size_t size) {
  std::vector<Index> numbers(size);
  Index next = 0;
  for (Index i = 0; i < size; ++i) {
    const Index first = sets.find(i);
    numbers[i] = first == i ? next++ : numbers[first];
  }
  return numbers;
}

}  // namespace kdm
