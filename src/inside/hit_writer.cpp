// SPDX-License-Identifier: MIT
// Writes hits, and numbers their planes.
#include "inside/hit_writer.h"

#include <utility>

namespace kdm {

HitWriter::HitWriter(const Surface& surface, std::size_t expected_hits, GridData& grid)
    : surface_(surface), grid_(grid), plane_number_(2 * surface.triangles.size(), kNone) {
  grid.edge_begin.assign(4 * std::size_t{grid.splits()} + 1, 0);
  grid.hits.clear();
  grid.hits.reserve(expected_hits);
  triangle_of_hit_.reserve(expected_hits);
  grid.planes.clear();
  grid.source_faces.clear();
  grid.source_operands.clear();
}

void HitWriter::add(const EdgePlace& edge, const ClassifiedCrossing& crossing) {
  const TriangleId triangle = crossing.triangle();
  const bool leaving = crossing.leaving();
  // By the lattice's triangle, as crossings are found: the plane before rounding may have another
  // sign where it is nearly parallel to the edge.
  const bool turned = points_up(surface_.triangles[triangle], edge.axis) != leaving;
  grid_.hits.push_back(Hit(crossing.position(), plane_of(triangle, turned), leaving,
                           reversed_on_edge(edge.i, leaving)));
  triangle_of_hit_.push_back(triangle);
}

void HitWriter::add_invented(const EdgePlace& edge, LinePosition position, bool leaving,
                             const Plane& plane) {
  const auto number = static_cast<PlaneId>(grid_.planes.size());
  grid_.planes.push_back(plane);
  grid_.source_faces.push_back(kNone);
  grid_.hits.push_back(Hit(position, number, leaving, reversed_on_edge(edge.i, leaving)));
  triangle_of_hit_.push_back(kNone);
}

PlaneId HitWriter::plane_of(TriangleId triangle, bool turned) {
  PlaneId& number = plane_number_[2 * std::size_t{triangle} + (turned ? 1 : 0)];
  if (number == kNone) {
    number = static_cast<PlaneId>(grid_.planes.size());
    const Plane& plane = surface_.planes[triangle];
    grid_.planes.push_back(turned ? Plane{-plane.normal, -plane.offset} : plane);
    grid_.source_faces.push_back(surface_.source_faces[triangle]);
    if (surface_.has_operands()) {
      grid_.source_operands.push_back(surface_.operand_of_solid[surface_.solid_of[triangle]]);
    }
  }
  return number;
}

std::vector<TriangleId> HitWriter::finish() {
  grid_.hits.shrink_to_fit();
  grid_.planes.shrink_to_fit();
  grid_.source_faces.shrink_to_fit();
  grid_.source_operands.shrink_to_fit();
  return std::move(triangle_of_hit_);
}

}  // namespace kdm
