// SPDX-License-Identifier: MIT
// Computes what follows from the grid's arrays, and implements class Grid, which owns them.
#include "grid/grid_data.h"

namespace kdm {
namespace {

template <typename T>
std::size_t bytes_of(const std::vector<T>& v) {
  return v.capacity() * sizeof(T);
}

}  // namespace

std::size_t GridData::bytes() const {
  return bytes_of(cells) + bytes_of(edge_begin) + bytes_of(hits) + bytes_of(opposite) +
         bytes_of(start) + bytes_of(planes) + bytes_of(source_faces) + bytes_of(source_operands) +
         bytes_of(rims) + bytes_of(corners) + bytes_of(operands) + bytes_of(exact.positions) +
         bytes_of(exact.triangles) + bytes_of(exact.source_faces) +
         bytes_of(exact.source_operands) + sizeof(GridData);
}

std::vector<LatticeBox> cell_boxes(const GridData& grid) {
  std::vector<LatticeBox> boxes(grid.cells.size());
  // A child's number is greater than its parent's, so parents come first.
  for (std::size_t c = 0; c < grid.cells.size(); ++c) {
    const Cell& cell = grid.cells[c];
    if (cell.leaf()) continue;
    LatticeBox box = boxes[c];
    box.hi[cell.axis()] = cell.value();
    boxes[cell.below()] = box;
    box = boxes[c];
    box.lo[cell.axis()] = cell.value();
    boxes[cell.above()] = box;
  }
  return boxes;
}

void mark_active_sides(GridData& grid) {
  for (std::size_t c = grid.cells.size(); c-- > 0;) {
    Cell& cell = grid.cells[c];
    if (cell.leaf()) continue;
    const Cell& below = grid.cells[cell.below()];
    const Cell& above = grid.cells[cell.above()];
    for (int axis = 0; axis < 3; ++axis) {
      for (const bool high : {false, true}) {
        bool active = false;
        if (axis == cell.axis()) {
          active = (high ? above : below).active(axis, high);
        } else {
          const int i = edge_on_side(cell.axis(), axis, high);
          active = below.active(axis, high) || above.active(axis, high) ||
                   !grid.edge_hits(cell.split(), i).empty();
        }
        if (active) cell.set_active(axis, high);
      }
    }
  }
}

Grid::Grid() : data_(std::make_unique<GridData>()) {}
Grid::Grid(std::unique_ptr<GridData> data) : data_(std::move(data)) {}
Grid::Grid(const Grid& other) : data_(std::make_unique<GridData>(other.data())) {}
Grid& Grid::operator=(const Grid& other) {
  if (this != &other) data_ = std::make_unique<GridData>(other.data());
  return *this;
}
Grid::Grid(Grid&& other) noexcept : data_(std::move(other.data_)) {}
Grid& Grid::operator=(Grid&& other) noexcept {
  data_ = std::move(other.data_);
  return *this;
}
Grid::~Grid() = default;

const GridData& Grid::data() const {
  static const GridData kEmpty;
  return data_ ? *data_ : kEmpty;  // none after a move
}
const GridStats& Grid::stats() const { return data().stats; }
const InputReport& Grid::input() const { return data().input; }
const std::vector<InputReport>& Grid::operands() const { return data().operands; }

}  // namespace kdm
