// SPDX-License-Identifier: MIT
// The topology test: would the surface in a cell that stays a leaf keep its topology?
//
// It does if every piece is a disk that reaches the cell's edges, no face of the cell holds a
// closed curve, and no closed part of the surface lies all around one edge. At the rim of a sheet
// pieces may be half-disks. Where all leaves pass, and no two triangles cross
// (crossing_triangles.h), the result is homeomorphic to the input.
#pragma once

#include <optional>
#include <variant>

#include "split/cell_surface.h"
#include "split/face_sections.h"
#include "split/one_way_sections.h"
#include "split/pillow_search.h"

namespace kdm {

/// Some piece is no disk, or reaches no edge of the cell.
struct NoDisk {};

/// A piece of a closed part that would come out without volume.
struct Pillow {
  PieceId piece;
};

/// What is wrong with the topology of a cell: the first fault that was found.
using TopologyFault = std::variant<ClosedCurve, NoDisk, Pillow>;

/// Tests cell after cell.
class TopologyCheck {
 public:
  explicit TopologyCheck(const Surface& surface)
      : open_surface_(has_open_sides(surface)), pillows_(surface) {}

  /// Returns the first fault of the cell, if it has any. The cell's pieces must have been found.
  /// Pieces that bound nothing have none.
  std::optional<TopologyFault> find_fault(const CellSurface& cell);
  /// Tells whether it is certain that no two triangles cross within the cell, without looking at
  /// pairs of them. The cell must be the one that was tested last, and have no fault.
  bool is_surely_embedded(const CellSurface& cell) const { return one_way_.are_of_a_graph(cell); }

 private:
  bool open_surface_;
  OneWaySections one_way_;
  FaceSections sections_;
  PillowSearch pillows_;
};

}  // namespace kdm
