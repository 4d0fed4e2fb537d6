// SPDX-License-Identifier: MIT
// What keeps an index mesh from being 2-manifold, one by one: `describe` counts it, `analyze` lists
// it.
#pragma once

#include <vector>

#include "kdmanifold/mesh.h"

namespace kdm {

/// An edge with one face, in the direction in which that runs along it.
struct BoundaryEdge {
  Edge vertices;
  std::array<Index, 2> fans;  ///< at its two ends: corners at one vertex that edges join share one
  Index face;
};

/// Faces joined by edges.
struct PartTopology {
  Index first_face = kNone;
  Index faces = 0;
  Index edges = 0;
  Index fans = 0;        ///< its vertices, those where parts of it only touch counted apart
  bool manifold = true;  ///< no edge has three or more faces
  bool balanced = true;  ///< every edge is used equally often in both directions
  bool agreeing = true;  ///< no edge with two faces is used twice in one direction
};

/// Faces with a repeated vertex are listed and take no other part. Lists ascend; edges do so by
/// the lower, then by the higher vertex.
struct MeshFaults {
  std::vector<BoundaryEdge> boundary_edges;
  std::vector<Edge> non_manifold_edges;  ///< lower vertex first; three or more faces
  std::vector<Edge> misoriented_edges;   ///< lower vertex first; two faces that run the same way
  std::vector<Index> non_manifold_vertices;
  std::vector<Index> degenerate_faces;
  std::vector<Index> duplicate_faces;  ///< over the vertices of a face with a lower number
  std::vector<Index> part_of;          ///< one a face; kNone for degenerate ones
  std::vector<PartTopology> parts;     ///< in order of their first faces
  Index edges = 0;
  Index vertices = 0;  ///< that faces use
};

/// Linear in the faces up to sorting. Throws `kInvalidMesh` if a face names a vertex that does not
/// exist or there are 2^29 faces or more.
MeshFaults find_faults(const Mesh& mesh);

}  // namespace kdm
