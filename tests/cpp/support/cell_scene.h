// SPDX-License-Identifier: MIT
// One cell of a grid over a mesh, made without a grid: for tests of what is decided cell by cell.
#pragma once

#include <algorithm>

#include "split/cell_surface.h"
#include "support/shapes.h"

namespace kdm::check {

/// Returns the part and two boxes far off, so that the lattice has room for cells around the part.
/// The part must lie within 2 of the origin.
inline Mesh with_room(const Mesh& part) {
  return shapes::merged({part, shapes::box(Vec3(-3, -3, -3), Vec3(-2.5, -2.5, -2.5)),
                         shapes::box(Vec3(2.5, 2.5, 2.5), Vec3(3, 3, 3))});
}

/// A mesh and a cell given in model coordinates, with the crossings on the cell's edges and the
/// surface's pieces in it. All crossings are kept, that is, they will be hits.
class CellScene {
 public:
  CellScene(const Mesh& mesh, const Vec3& lo, const Vec3& hi)
      : surface(prepare_surface(mesh)),
        box{surface.lattice.quantise(lo), surface.lattice.quantise(hi)},
        surface_in_cell(surface),
        lists_(surface.triangles),
        list_(lists_.all()) {
    for (int axis = 0; axis < 3; ++axis) {
      list_ = lists_.divide(list_, axis, box.lo[axis]).above;
      list_ = lists_.divide(list_, axis, box.hi[axis]).below;
    }
    find_crossings();
    surface_in_cell.crossings.collect(view());
    surface_in_cell.find_pieces(box, entries());
  }
  CellScene(const CellScene&) = delete;
  CellScene& operator=(const CellScene&) = delete;

  std::span<const ListEntry> entries() const { return lists_.entries(list_); }
  CellView view(int depth = 0) const { return {box, depth, entries(), {}, edges_, crossings_}; }
  /// Returns a length in lattice units.
  double in_lattice(double model) const { return model / surface.lattice.step; }
  /// Returns a coordinate on the lattice, not rounded.
  double on_lattice(double model, int axis) const {
    return surface.lattice.to_lattice(Vec3::Constant(model))[axis];
  }

  const Surface surface;
  const LatticeBox box;
  CellSurface surface_in_cell;

 private:
  // Tries every triangle on every edge of the cell.
  void find_crossings() {
    for (int axis = 0; axis < 3; ++axis) {
      for (int ends = 0; ends < 4; ++ends) {
        const bool high_next = (ends & 1) != 0;
        const bool high_previous = (ends & 2) != 0;
        EdgeRange& edge = edges_[cell_edge(axis, high_next, high_previous)];
        edge.begin = static_cast<Index>(crossings_.size());
        const LatticePoint start = corner_on_plane(box, axis, 0, high_next, high_previous);
        const std::int32_t u = start[next_axis(axis)];
        const std::int32_t v = start[previous_axis(axis)];
        for (TriangleId t = 0; t < surface.triangles.size(); ++t) {
          if (line_crosses(surface.triangles[t], axis, u, v) == 0) continue;
          const LinePosition position = crossing_position(surface.triangles[t], axis, u, v);
          if (floor_of(position) < box.lo[axis] || floor_of(position) >= box.hi[axis]) continue;
          crossings_.emplace_back(position, t, 0, CrossingRole::kBounds, false);
        }
        edge.end = static_cast<Index>(crossings_.size());
        std::sort(crossings_.begin() + edge.begin, crossings_.end(),
                  [](const auto& a, const auto& b) { return a.position() < b.position(); });
      }
    }
  }

  TriangleLists lists_;
  ListRange list_;
  CellEdges edges_{};
  std::vector<ClassifiedCrossing> crossings_;
};

}  // namespace kdm::check
