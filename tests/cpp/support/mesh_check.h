// SPDX-License-Identifier: MIT
// The judge of the tests: says whether a mesh is a closed, oriented 2-manifold. Shares no code and
// no method with the library's `describe`: ordered maps, walks around vertices, flood fill. Slow.
#pragma once

#include <cstdint>
#include <string>

#include "kdmanifold/mesh.h"

namespace kdm::check {

/// Faces with a repeated vertex are counted and take no other part.
struct MeshCheck {
  int boundary_edges = 0;         ///< edges with one face
  int boundary_loops = 0;         ///< closed walks along them; means nothing if there are faults
  int non_manifold_edges = 0;     ///< edges with three or more
  int misoriented_edges = 0;      ///< edges whose two faces run the same way
  int non_manifold_vertices = 0;  ///< the edges opposite to the vertex form no single path or ring
  int degenerate_faces = 0;       ///< a vertex repeated
  int duplicate_faces = 0;        ///< the vertex set of an earlier face
  int bad_indices = 0;            ///< corners that name no vertex; then nothing else is counted
  int bad_positions = 0;          ///< referenced vertices with a coordinate that is not finite
  int components = 0;             ///< faces joined by edges
  std::int64_t euler_characteristic = 0;
  bool closed = false;        ///< there are faces, and no edge has one
  bool oriented = false;      ///< every edge is used equally often in both directions
  bool two_manifold = false;  ///< closed, oriented and without any fault
  bool manifold = false;      ///< the same but for boundary edges
  double volume = 0;

  /// All faults in one line, "" if there are none.
  std::string faults() const;
};

MeshCheck check_mesh(const Mesh& mesh);

}  // namespace kdm::check
