// SPDX-License-Identifier: MIT
// Planes without hits dropped.
#include "build/used_planes.h"

#include <utility>

namespace kdm {

void keep_used_planes(GridData& grid) {
  std::vector<Index> number(grid.planes.size(), kNone);
  Index used = 0;
  for (Hit& hit : grid.hits) {
    Index& plane = number[hit.plane()];
    if (plane == kNone) plane = used++;
    hit = Hit(hit.position, plane, hit.leaving(), hit.reversed());
  }
  std::vector<Plane> planes(used);
  std::vector<Index> source_faces(used);
  for (std::size_t face = 0; face < number.size(); ++face) {
    if (number[face] == kNone) continue;
    planes[number[face]] = grid.planes[face];
    source_faces[number[face]] = grid.source_faces[face];
  }
  grid.planes = std::move(planes);
  grid.source_faces = std::move(source_faces);
}

}  // namespace kdm
