// SPDX-License-Identifier: MIT
// Drops and turns faces while they are prepared.
#pragma once

#include <utility>

#include "mesh/marks.h"
#include "prepare/faces.h"

namespace kdm {

/// Keeps the triangles for whose number `keep` is true, in their order; `keep` is called once for
/// each, in that order. Returns how many were dropped. The topology becomes invalid.
template <typename Keep>
Index keep_faces(InputFaces& faces, const Keep& keep) {
  const std::size_t all = faces.triangles.size();
  const std::size_t first_patch = all - faces.patch_planes.size();
  std::size_t kept = 0;
  std::size_t kept_patches = 0;
  for (std::size_t i = 0; i < all; ++i) {
    if (!keep(i)) continue;
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

/// Turns the marked triangles round, by exchanging corners 1 and 2. The topology becomes invalid.
inline void turn_faces(InputFaces& faces, const Marks& must_turn) {
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

/// Finds the topology anew.
inline void find_topology(InputFaces& faces) {
  faces.topology = build_topology(faces.triangles, static_cast<Index>(faces.points.size()));
}

/// Drops triangles with two equal corners: they have no area.
void drop_repeated_corners(InputFaces& faces);

/// Returns the bounding box of the triangles.
Box bounds_of(const InputFaces& faces);

}  // namespace kdm
