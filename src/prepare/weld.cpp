// SPDX-License-Identifier: MIT
// Finds vertices of equal position by an open-addressing hash table.
#include "prepare/weld.h"

#include <cstring>

namespace kdm {
namespace {

std::uint64_t hash_of(const Vec3& p) {
  std::uint64_t h = 0;
  for (int i = 0; i < 3; ++i) {
    const double coordinate = p[i] + 0.0;  // -0 becomes 0
    std::uint64_t bits = 0;
    std::memcpy(&bits, &coordinate, sizeof bits);
    h = (h ^ bits) * 0x9e3779b97f4a7c15u;
    h ^= h >> 29;
  }
  return h;
}

}  // namespace

Weld weld_positions(const std::vector<Vec3>& positions) {
  std::size_t size = 16;
  while (size < 2 * positions.size()) size *= 2;
  std::vector<Index> table(size, kNone);
  Weld weld;
  weld.point_of.reserve(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    std::size_t slot = hash_of(positions[i]) & (size - 1);
    while (table[slot] != kNone && positions[weld.first_of[table[slot]]] != positions[i]) {
      slot = (slot + 1) & (size - 1);
    }
    if (table[slot] == kNone) {
      table[slot] = static_cast<Index>(weld.first_of.size());
      weld.first_of.push_back(static_cast<Index>(i));
    }
    weld.point_of.push_back(table[slot]);
  }
  return weld;
}

}  // namespace kdm
