// SPDX-License-Identifier: MIT
// What is wrong with a mesh from outside, with the faces, edges and vertices at fault.
#pragma once

#include <vector>

#include "kdmanifold/mesh.h"

namespace kdm {

/// Faces joined by edges, as far as they are not degenerate.
struct MeshPart {
  Index first_face = kNone;  ///< the lowest of its faces
  Index faces = 0;
  Index boundary_loops = 0;
  /// Every edge is used equally often in both directions: the part bounds something.
  bool closed = false;
  /// Handles; kNone where the part is no oriented surface, because it has misoriented edges or
  /// edges with three or more faces. Boundary loops count as if each were closed by a disk.
  Index genus = kNone;
  double area = 0;
  double volume = 0;  ///< signed, positive where normals point outwards; of closed parts, else 0
  /// Among the closed parts that hold this closed part, the smallest; kNone if there is none. Parts
  /// that cross each other hold none of each other.
  Index inside = kNone;
  /// Turned inwards within parts that are turned outwards: a hollow.
  bool cavity = false;
  /// Turned inwards without being a cavity, or within parts that are turned inwards themselves.
  bool inside_out = false;
};

/// Vertices of exactly equal position count as one: in lists the lowest of them stands for all.
/// Faces are the caller's, triangles first, then quads. Faces and vertices ascend; edges do so by
/// the lower, then by the higher vertex. Faces with a repeated vertex are in `degenerate_faces` and
/// play no part in any other list.
struct MeshDefects {
  MeshReport report;  ///< what `describe` says once vertices of equal position are joined
  /// There are faces, and every edge is used equally often in both directions: `build_grid`
  /// accepts no other mesh as a solid.
  bool balanced = false;
  std::vector<Edge> boundary_edges;      ///< one face; vertices in the order in which that has them
  std::vector<Edge> non_manifold_edges;  ///< three or more faces; lower vertex first
  std::vector<Edge> misoriented_edges;   ///< two faces that run the same way; lower vertex first
  /// The vertices of each closed round of boundary edges, in the direction of the faces where these
  /// agree. Boundary edges that form none (they end on non-manifold edges) are left out.
  std::vector<std::vector<Index>> boundary_loops;
  std::vector<Index> non_manifold_vertices;  ///< their faces do not form one fan
  std::vector<Index> degenerate_faces;       ///< a vertex repeated
  std::vector<Index> zero_area_faces;        ///< three (four) vertices, exactly on one line
  std::vector<Index> duplicate_faces;        ///< over the same vertices as a face before
  /// Turned against their neighbours, or with their whole part inwards, as far as volume and what
  /// can be seen from outside tell: those that the inside rule `kRepair` turns.
  std::vector<Index> flipped_faces;
  /// Only if asked for: faces that cross or touch others where they share no vertex or edge, and
  /// those that lie on each other. The number of their pairs: see `SelfIntersections`.
  std::vector<Index> self_intersecting_faces;
  std::uint64_t self_intersections = 0;
  std::vector<Index> part_of;   ///< one a face: number in `parts`; kNone for degenerate faces
  std::vector<MeshPart> parts;  ///< in order of their first faces
  /// False: thousands of closed parts overlap, so that nobody has looked which lie in which;
  /// `inside` is then kNone, `cavity` and `inside_out` false for all.
  bool nesting_known = true;
};

struct AnalyzeOptions {
  /// Look for self-intersections too: takes several times as long as all the rest, and far longer
  /// where many faces overlap that are no copies of each other.
  bool self_intersections = false;
};

/// Finds everything above. Without self-intersections n log n in the faces, and about a second on
/// top at most where many closed parts overlap. Any mesh may be given, also one without faces.
/// Throws `kInvalidMesh` if a face names a vertex that does not exist, a coordinate is not finite
/// or beyond 1e150, or there are 2^29 faces or more.
MeshDefects analyze(const Mesh& mesh, const AnalyzeOptions& options = {});

}  // namespace kdm
