// SPDX-License-Identifier: MIT
// Finds what keeps an index mesh from being 2-manifold. `describe` counts what is found here, and
// `analyze` lists it.
#pragma once

#include <vector>

#include "kdmanifold/mesh.h"

namespace kdm {

/// An edge with one face.
struct BoundaryEdge {
  Edge vertices;  ///< in the direction in which the face runs along the edge
  /// The fans that the edge is part of at its two ends. A fan consists of the faces at a vertex
  /// that are joined by edges; its number is that of one of the corners.
  std::array<Index, 2> fans;
  Index face;
};

/// A part of a mesh: faces joined by edges.
struct PartTopology {
  Index first_face = kNone;  ///< the lowest of its faces
  Index faces = 0;
  Index edges = 0;
  Index fans = 0;        ///< how many vertices it has, if each counts once for every fan at it
  bool manifold = true;  ///< no edge has three or more faces
  bool balanced = true;  ///< every edge is used equally often in both directions
  bool agreeing = true;  ///< no edge with two faces is used twice in one direction
};

/// The faults of a mesh, and its parts. Faces with a repeated vertex are listed as degenerate and
/// play no other role. Lists ascend; edges do so by their lower, then by their higher vertex.
struct MeshFaults {
  std::vector<BoundaryEdge> boundary_edges;
  std::vector<Edge> non_manifold_edges;      ///< with three or more faces; lower vertex first
  std::vector<Edge> misoriented_edges;       ///< with two faces that run the same way; lower first
  std::vector<Index> non_manifold_vertices;  ///< with several fans, or at a non-manifold edge
  std::vector<Index> degenerate_faces;       ///< with a repeated vertex
  std::vector<Index> duplicate_faces;        ///< over the vertices of a face with a lower number
  std::vector<Index> part_of;                ///< per face its part; kNone for degenerate ones
  std::vector<PartTopology> parts;           ///< in order of their first faces
  Index edges = 0;                           ///< how many there are
  Index vertices = 0;                        ///< how many are used by faces
};

/// Finds the faults of a mesh in time linear in the faces, up to sorting. Throws `kInvalidMesh` if
/// a face names a vertex that does not exist or there are 2^29 faces or more.
MeshFaults find_faults(const Mesh& mesh);

}  // namespace kdm
