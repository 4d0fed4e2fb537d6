// SPDX-License-Identifier: MIT
// Closed parts of the surface that would come out without volume (pillows).
#pragma once

#include <optional>
#include <vector>

#include "split/cell_surface.h"

namespace kdm {

/// Searches cells for pieces of pillows. One object serves cell after cell.
class PillowSearch {
 public:
  explicit PillowSearch(const Surface& surface) : surface_(surface) {}

  /// Returns a piece that crosses one edge of the cell only and is of a closed part which may lie
  /// wholly in the cells around that edge, if there is such a piece. Each of these cells would have
  /// one vertex of the part, and the faces between them would lie back to back.
  std::optional<PieceId> find_pillow(const CellSurface& cell);

 private:
  bool part_is_closed_and_near(TriangleId triangle, const LatticeBox& cell);

  const Surface& surface_;
  std::vector<Index> last_search_;  // per triangle: the number of the last search that met it
  Index searches_ = 0;
  std::vector<TriangleId> to_visit_;
};

}  // namespace kdm
