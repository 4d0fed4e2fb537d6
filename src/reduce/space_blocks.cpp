// SPDX-License-Identifier: MIT
#include "reduce/space_blocks.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "mesh/boxes.h"

namespace kdm {
namespace {

// Blocks are cut no further if one side would keep more than this part of the triangles.
constexpr double kMostKept = 0.8;

class Cutter {
 public:
  Cutter(const std::vector<Box>& boxes, Index most, double below)
      : boxes_(boxes), most_(most), below_(below) {}

  void cut(SpaceBlock block) {
    if (block.triangles.size() > most_) {
      const auto [axis, at] = place_in(block.triangles);
      SpaceBlock below{block.box, {}};
      SpaceBlock above{block.box, {}};
      below.box.max[axis] = at;
      above.box.min[axis] = at;
      for (const TriangleId t : block.triangles) {
        if (boxes_[t].min[axis] < at) below.triangles.push_back(t);
        if (boxes_[t].max[axis] >= at) above.triangles.push_back(t);
      }
      const std::size_t larger = std::max(below.triangles.size(), above.triangles.size());
      if (static_cast<double>(larger) < kMostKept * static_cast<double>(block.triangles.size())) {
        block = {};
        cut(std::move(below));
        cut(std::move(above));
        return;
      }
    }
    found.push_back(std::move(block));
  }

  std::vector<SpaceBlock> found;

 private:
  // Returns the axis along which the centres are furthest apart, and where to cut it.
  std::pair<int, double> place_in(const std::vector<TriangleId>& triangles) {
    Box all;
    for (const TriangleId t : triangles) grow(all, centre_of(boxes_[t]));
    int axis = 0;
    (all.max - all.min).maxCoeff(&axis);
    places_.clear();
    for (const TriangleId t : triangles) places_.push_back(centre_of(boxes_[t])[axis]);
    const auto at =
        places_.begin() + static_cast<std::ptrdiff_t>(below_ * static_cast<double>(places_.size()));
    std::nth_element(places_.begin(), at, places_.end());
    return {axis, *at};
  }

  const std::vector<Box>& boxes_;
  Index most_;
  double below_;
  std::vector<double> places_;
};

}  // namespace

std::vector<SpaceBlock> cut_space(const std::vector<Box>& boxes, Index most, double below) {
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  SpaceBlock all{{Vec3::Constant(-kEndless), Vec3::Constant(kEndless)}, {}};
  for (TriangleId t = 0; t < boxes.size(); ++t) {
    if (boxes[t].min.x() <= boxes[t].max.x()) all.triangles.push_back(t);
  }
  Cutter cutter(boxes, most, below);
  cutter.cut(std::move(all));
  return std::move(cutter.found);
}

}  // namespace kdm
