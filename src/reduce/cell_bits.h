// SPDX-License-Identifier: MIT
// A raster of cubes, some of which are marked.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/boxes.h"

namespace kdm {

/// One bit for each cube of a box, set near to segments. Points outside of the box are in no cube.
class CellBits {
 public:
  CellBits() = default;
  /// The cubes are `width` wide, or wider where there would be more than 512 along a side. An
  /// empty box has none. The segments must lie in the box: all points within half a cube's width of
  /// them are in marked cubes, and none that is further than 3.5 widths.
  CellBits(const Box& box, double width, const std::vector<std::array<Vec3, 2>>& segments);

  /// Tells whether the point is in a marked cube.
  bool test(const Vec3& p) const {
    const Vec3 place = (p - corner_) * scale_;
    for (int axis = 0; axis < 3; ++axis) {
      if (!(place[axis] >= 0 && place[axis] < static_cast<double>(counts_[axis]))) return false;
    }
    const std::array<std::int64_t, 3> cell = cell_of(p);
    return (words_[word_of(cell)] >> (cell[0] % kBits) & 1) != 0;
  }

 private:
  static constexpr std::int64_t kBits = 64;

  void mark(const std::vector<std::array<Vec3, 2>>& segments);
  void mark_round(const std::array<std::int64_t, 3>& cell);
  std::array<std::int64_t, 3> cell_of(const Vec3& p) const {
    std::array<std::int64_t, 3> cell{};
    for (int axis = 0; axis < 3; ++axis) {
      cell[axis] = static_cast<std::int64_t>((p[axis] - corner_[axis]) * scale_);
    }
    return cell;
  }
  std::size_t word_of(const std::array<std::int64_t, 3>& cell) const {
    return static_cast<std::size_t>((cell[2] * counts_[1] + cell[1]) * row_ + cell[0] / kBits);
  }

  Vec3 corner_ = Vec3::Zero();
  double scale_ = 0;  // cubes per unit
  std::array<std::int64_t, 3> counts_{};
  std::int64_t row_ = 0;  // words a row of cubes along x
  std::vector<std::uint64_t> words_;
};

}  // namespace kdm
