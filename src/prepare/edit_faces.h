// SPDX-License-Identifier: MIT
// Drops and turns faces while they are prepared.
#pragma once

#include "mesh/marks.h"
#include "prepare/faces.h"

namespace kdm {

/// Drops the marked triangles; the others keep their order. Returns how many were dropped. The
/// topology becomes invalid.
Index drop_faces(InputFaces& faces, const Marks& dropped);

/// Turns the marked triangles round, by exchanging corners 1 and 2. The topology becomes invalid.
void turn_faces(InputFaces& faces, const Marks& must_turn);

/// Finds the topology anew.
inline void find_topology(InputFaces& faces) {
  faces.topology = build_topology(faces.triangles, static_cast<Index>(faces.points.size()));
}

/// Drops triangles with two equal corners: they have no area. Returns how many there were; if there
/// were any, the topology becomes invalid.
Index drop_repeated_corners(InputFaces& faces);

/// Returns the bounding box of the triangles.
Box bounds_of(const InputFaces& faces);

}  // namespace kdm
