// SPDX-License-Identifier: MIT
// How well sharp edges are kept, for tables; not part of the library.
#pragma once

#include "distance.h"

namespace kdm::bench {

struct EdgeDistance {
  double reference_length = 0;  ///< of the reference's sharp edges
  double length = 0;            ///< of the mesh's
  Distance to_surface;          ///< from points on the reference's sharp edges to the mesh
  Distance to_edges;            ///< from the same points to the mesh's sharp edges
};

/// Sharp are the reference's edges whose two faces' normals enclose more than `degrees`, and the
/// mesh's where it is more than two thirds of that: an edge at the limit must not count as lost
/// because its faces have turned a little. Vertices at equal positions are taken for one.
EdgeDistance sharp_edge_distance(const Mesh& reference, const Mesh& mesh, double degrees,
                                 Index samples);

/// Counts the mesh's edges that turn by more than 30 degrees where no edge of the reference that
/// turns by more than 15 is within half a per cent of the reference's diagonal: scratches that a
/// viewer sees on a smooth surface.
Index count_false_creases(const Mesh& reference, const Mesh& mesh);

}  // namespace kdm::bench
