// SPDX-License-Identifier: MIT
// The judge of the tests: tells whether a mesh is a closed, oriented 2-manifold. It shares no code
// and no method with the library's `describe`: it uses ordered maps, walks round vertices and a
// flood fill, and is slow.
#pragma once

#include <cstdint>
#include <string>

#include "kdmanifold/extract.h"

namespace kdm::check {

/// What the judge found. Faces with a repeated vertex are counted and play no other role.
struct MeshCheck {
  int boundary_edges = 0;         ///< edges with one face
  int boundary_loops = 0;         ///< closed walks along them; means nothing if there are faults
  int non_manifold_edges = 0;     ///< edges with three or more faces
  int misoriented_edges = 0;      ///< edges whose two faces run the same way
  int non_manifold_vertices = 0;  ///< the faces round the vertex form no single fan or ring
  int degenerate_faces = 0;       ///< faces with a repeated vertex
  int duplicate_faces = 0;        ///< faces over the vertices of an earlier face
  int bad_indices = 0;            ///< corners that name no vertex; then nothing else is counted
  int bad_positions = 0;          ///< referenced vertices with a coordinate that is not finite
  bool falls_together = false;    ///< of a result: it is another mesh once welded by position
  int components = 0;             ///< parts of faces joined by edges
  std::int64_t euler_characteristic = 0;
  bool closed = false;        ///< there are faces, and no edge has one
  bool oriented = false;      ///< every edge is used equally often in both directions
  bool two_manifold = false;  ///< closed, and without any fault
  bool manifold = false;      ///< not empty, and without any fault but boundary edges
  double volume = 0;

  /// Returns all faults in one line, or "" if there are none.
  std::string faults() const;
};

MeshCheck check_mesh(const Mesh& mesh);

/// The same of a result. If it is said to cross nowhere, it must also be 2-manifold once its
/// vertices are told by their positions in 32 bits alone, as readers of STL files do.
MeshCheck check_mesh(const ExtractedMesh& mesh);

/// Returns the mesh with coordinates rounded to 32 bits and one vertex for each position.
Mesh welded_in_single(const Mesh& mesh);

}  // namespace kdm::check
