// SPDX-License-Identifier: MIT
// Planes without hits dropped, the others turned.
#include "link/used_planes.h"

#include <utility>

namespace kdm {
namespace {

class PlaneSelection {
 public:
  explicit PlaneSelection(std::size_t faces) : number_(2 * faces, kNone) {}

  Index number_of(Index face, bool turned) {
    const std::size_t wanted = 2 * std::size_t{face} + (turned ? 1 : 0);
    if (number_[wanted] == kNone) number_[wanted] = used_++;
    return number_[wanted];
  }

  void apply(GridData& grid) const {
    std::vector<Plane> planes(used_);
    std::vector<Index> source_faces(used_);
    for (std::size_t i = 0; i < number_.size(); ++i) {
      if (number_[i] == kNone) continue;
      const Plane& plane = grid.planes[i / 2];
      planes[number_[i]] = i % 2 == 0 ? plane : Plane{-plane.normal, -plane.offset};
      source_faces[number_[i]] = grid.source_faces[i / 2];
    }
    grid.planes = std::move(planes);
    grid.source_faces = std::move(source_faces);
  }

 private:
  std::vector<Index> number_;  // two a face: as it is, and turned
  Index used_ = 0;
};

}  // namespace

void keep_used_planes(const Surface& surface, GridData& grid) {
  PlaneSelection selection(grid.planes.size());
  std::vector<int> split_axis(grid.splits());
  for (const Cell& cell : grid.cells) {
    if (!cell.leaf()) split_axis[cell.split()] = cell.axis();
  }
  for (Index edge = 0; edge < 4 * grid.splits(); ++edge) {
    const int axis = axis_of_edge(split_axis[edge / 4], static_cast<int>(edge % 4));
    for (Index h = grid.edge_begin[edge]; h < grid.edge_begin[edge + 1]; ++h) {
      Hit& hit = grid.hits[h];
      // By the lattice's triangle, as hits are found: the plane before rounding may have another
      // sign where it is nearly parallel to the edge. Planes without triangle are turned rightly.
      const bool turned = hit.plane() < surface.triangles.size() &&
                          points_up(surface.triangles[hit.plane()], axis) != hit.leaving();
      hit = Hit(hit.position, selection.number_of(hit.plane(), turned), hit.leaving(),
                hit.reversed());
    }
  }
  selection.apply(grid);
}

}  // namespace kdm
