// SPDX-License-Identifier: MIT
// The grid vertices of a grid whose cells are made, with a state each, to be looked up by line.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "grid/grid_data.h"

namespace kdm {

/// The states of grid vertices on any line along an axis.
class GridVertices {
 public:
  /// A vertex: its place on the line, and its state.
  struct Vertex {
    std::uint64_t key;  ///< 21 bits each for the coordinates across the line, then along it
    int state;

    std::int32_t along() const { return static_cast<std::int32_t>(key & 0x1fffffu); }
  };

  /// Asks for the state of each vertex once. `boxes` come from `cell_boxes`.
  GridVertices(const GridData& grid, const std::vector<LatticeBox>& boxes,
               const std::function<int(const LatticePoint&)>& state_at);

  /// Returns the vertices from `low` up to `high`, both of which must be vertices, on the line
  /// along `axis` through `low`.
  std::span<const Vertex> between(int axis, const LatticePoint& low, std::int32_t high) const;

 private:
  std::array<std::vector<Vertex>, 3> on_lines_;  // per axis, ascending by key
};

}  // namespace kdm
