// SPDX-License-Identifier: MIT
// Keeps what belongs to faces in step.
#include "prepare/edit_faces.h"

#include <utility>

#include "mesh/boxes.h"

namespace kdm {

Index drop_faces(InputFaces& faces, const Marks& dropped) {
  const std::size_t all = faces.triangles.size();
  const std::size_t first_patch = all - faces.patch_planes.size();
  std::size_t kept = 0;
  std::size_t kept_patches = 0;
  for (std::size_t i = 0; i < all; ++i) {
    if (dropped.test(i)) continue;
    faces.triangles[kept] = faces.triangles[i];
    faces.source_faces[kept] = faces.source_faces[i];
    ++kept;
    if (i >= first_patch) faces.patch_planes[kept_patches++] = faces.patch_planes[i - first_patch];
  }
  faces.triangles.resize(kept);
  faces.source_faces.resize(kept);
  faces.patch_planes.resize(kept_patches);
  return static_cast<Index>(all - kept);
}

void turn_faces(InputFaces& faces, const Marks& must_turn) {
  const std::size_t first_patch = faces.triangles.size() - faces.patch_planes.size();
  for (std::size_t i = 0; i < faces.triangles.size(); ++i) {
    if (!must_turn.test(i)) continue;
    std::swap(faces.triangles[i][1], faces.triangles[i][2]);
    if (i >= first_patch) {
      Vec3& normal = faces.patch_planes[i - first_patch].normal;
      normal = -normal;
    }
  }
}

Index drop_repeated_corners(InputFaces& faces) {
  Marks repeated(faces.triangles.size());
  for (std::size_t i = 0; i < faces.triangles.size(); ++i) {
    const Triangle& t = faces.triangles[i];
    repeated.set(i, t[0] == t[1] || t[1] == t[2] || t[2] == t[0]);
  }
  const Index dropped = drop_faces(faces, repeated);
  faces.report.degenerate_faces += dropped;
  return dropped;
}

Box bounds_of(const InputFaces& faces) {
  Box bounds;
  for (const Triangle& t : faces.triangles) {
    for (const Index corner : t) grow(bounds, faces.points[corner]);
  }
  return bounds;
}

}  // namespace kdm
