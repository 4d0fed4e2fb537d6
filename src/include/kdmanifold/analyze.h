// SPDX-License-Identifier: MIT
// Finds what is wrong with a mesh, with the faces, edges and vertices at fault.
#pragma once

#include <vector>

#include "kdmanifold/mesh.h"

namespace kdm {

/// Faces joined by edges. Degenerate faces (with a repeated vertex) belong to no part.
struct MeshPart {
  Index first_face = kNone;  ///< the lowest of its faces
  Index faces = 0;           ///< number of its faces
  Index boundary_loops = 0;  ///< number of closed rounds of boundary edges
  bool closed = false;       ///< every edge is used equally often in both directions
  /// Number of handles. Boundary loops count as if each were closed by a disk. kNone where the part
  /// is no oriented surface, because it has misoriented edges or edges with three or more faces.
  Index genus = kNone;
  double area = 0;    ///< square model units
  double volume = 0;  ///< cubic model units, signed: positive where normals point outwards; 0 for
                      ///< parts that are not closed
  /// Number of the smallest closed part that holds this closed part; kNone if there is none. Two
  /// parts that cross do not hold each other.
  Index inside = kNone;
  bool cavity = false;      ///< turned inwards within parts that are turned outwards: a hollow
  bool inside_out = false;  ///< turned inwards without being a cavity, or within parts that are
                            ///< turned inwards themselves
};

/// What `analyze` finds. Vertices of exactly equal position count as one: in lists the lowest of
/// them stands for all. Faces are numbered as in the mesh, triangles first, then quads. Faces and
/// vertices ascend; edges do so by the lower, then by the higher vertex. Faces with a repeated
/// vertex are in `degenerate_faces` and play no part in any other list.
struct MeshDefects {
  MeshReport report;  ///< what `describe` says once vertices of equal position are joined
  /// There are faces, and every edge is used equally often in both directions. The inside rules
  /// `kPositive`, `kOdd` and `kNonzero` accept no other mesh; `kRepair` takes it exactly as it is
  /// and repairs others.
  bool balanced = false;
  std::vector<Edge> boundary_edges;      ///< one face; vertices in that face's order
  std::vector<Edge> non_manifold_edges;  ///< three or more faces; lower vertex first
  std::vector<Edge> misoriented_edges;   ///< two faces that run the same way; lower vertex first
  /// The vertices of each closed round of boundary edges, in the direction of the faces where these
  /// agree. Boundary edges that form none (they end on non-manifold edges) are left out.
  std::vector<std::vector<Index>> boundary_loops;
  std::vector<Index> non_manifold_vertices;  ///< vertices whose faces do not form one fan
  std::vector<Index> degenerate_faces;       ///< faces with a repeated vertex
  std::vector<Index> zero_area_faces;        ///< faces of different vertices, exactly on one line
  std::vector<Index> duplicate_faces;        ///< faces over the same vertices as a face before
  /// Faces turned against their neighbours, or with their whole part inwards, as far as volume and
  /// what can be seen from outside tell: those that the inside rule `kRepair` turns.
  std::vector<Index> flipped_faces;
  /// Only if asked for: faces that cross or touch others where they share no vertex or edge, and
  /// faces that lie on each other.
  std::vector<Index> self_intersecting_faces;
  std::uint64_t self_intersections = 0;  ///< number of pairs of these; see `SelfIntersections`
  std::vector<Index> part_of;            ///< one a face: number in `parts`; kNone if degenerate
  std::vector<MeshPart> parts;           ///< in order of their first faces
  /// False if thousands of closed parts overlap, so that nobody has looked which lie in which. Then
  /// `inside` is kNone, `cavity` and `inside_out` are false for all parts.
  bool nesting_known = true;
};

/// What `analyze` can be told.
struct AnalyzeOptions {
  /// Looks for self-intersections too. Takes several times as long as all the rest, and far longer
  /// where many faces overlap that are no copies of each other.
  bool self_intersections = false;
};

/// Finds the defects of any mesh, also of one without faces. Without self-intersections it takes n
/// log n in the faces, and about a second on top at most where many closed parts overlap. Throws
/// `kInvalidMesh` if a face names a vertex that does not exist, a coordinate is not finite or
/// beyond 1e150, or there are 2^29 faces or more.
MeshDefects analyze(const Mesh& mesh, const AnalyzeOptions& options = {});

}  // namespace kdm
