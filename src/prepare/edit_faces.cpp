// SPDX-License-Identifier: MIT
// Drops faces without area and measures those that are left.
#include "prepare/edit_faces.h"

#include "mesh/boxes.h"

namespace kdm {

void drop_repeated_corners(InputFaces& faces) {
  faces.report.degenerate_faces += keep_faces(faces, [&](std::size_t i) {
    const Triangle& t = faces.triangles[i];
    return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
  });
}

Box bounds_of(const InputFaces& faces) {
  Box bounds;
  for (const Triangle& t : faces.triangles) {
    for (const Index corner : t) grow(bounds, faces.points[corner]);
  }
  return bounds;
}

}  // namespace kdm
