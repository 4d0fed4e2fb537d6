// SPDX-License-Identifier: MIT
// A polygon mesh and what can be said about it.
#pragma once

#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

/// Triangles (and, from `extract` with `quads`, quads) over shared vertex positions.
struct Mesh {
  std::vector<Vec3> positions;      ///< of the vertices, in model units
  std::vector<Triangle> triangles;  ///< three vertices each
  std::vector<Quad> quads;          ///< four vertices each
  /// Where each face comes from: one entry a triangle, then one a quad, or empty. After
  /// `read_mesh`: the file's face (from 0) that the triangle was cut from. After `extract`: the
  /// entry of the input triangle that the face stands for, or, if the input had no such list, the
  /// number of that triangle; kNone for faces that close a hole or
  /// the rims where a handle was cut.
  std::vector<Index> source_faces;
  /// Unit normals for shading, or empty: three a triangle in the order of its corners, then four a
  /// quad. `extract` makes them on request; of the file formats, OBJ keeps them.
  std::vector<std::array<float, 3>> corner_normals;
  /// After a Boolean operation: the operand whose face each entry of `source_faces` names; kNone
  /// for the box within which a complement was taken. Otherwise empty.
  std::vector<Index> source_operands = {};
};

/// Counts over the mesh as an index mesh: two faces meet where they use the same vertex numbers.
/// Degenerate faces are counted and take no part in edges, fans, duplicates, components and the
/// Euler characteristic.
struct MeshReport {
  Index vertices = 0;               ///< positions, also unreferenced ones
  Index triangles = 0;              ///< faces with three corners
  Index quads = 0;                  ///< faces with four corners
  Index unreferenced_vertices = 0;  ///< positions that no face uses
  Index boundary_edges = 0;         ///< edges with one face
  /// Closed rounds of boundary edges; those that touch in a vertex count apart.
  Index boundary_loops = 0;
  Index non_manifold_edges = 0;           ///< edges with three or more faces
  Index misoriented_edges = 0;            ///< edges whose two faces run the same way along it
  Index non_manifold_vertices = 0;        ///< vertices whose faces do not form one fan; the ends of
                                          ///< non-manifold edges are among them
  Index degenerate_faces = 0;             ///< faces with a repeated vertex
  Index duplicate_faces = 0;              ///< faces over the same vertices as an earlier one
  Index components = 0;                   ///< parts joined by edges
  std::int64_t euler_characteristic = 0;  ///< referenced vertices - edges + faces
  bool closed = false;                    ///< no edge with one face, and at least one face
  bool two_manifold = false;              ///< closed, and none of the faults above
  /// At least one face, and none of the faults above but that there may be a boundary.
  bool manifold = false;
  double volume = 0;  ///< cubic model units, signed: positive where normals point outwards; means
                      ///< nothing unless the mesh is closed and oriented
  /// Square model units; a quad counts as its two triangles at the corners 0 and 2.
  double area = 0;
  Box bounds;  ///< bounding box of the referenced vertices, in model units
};

/// Counts what `MeshReport` holds. The time grows linearly with the faces, up to sorting. Throws
/// `kInvalidMesh` if a face names a vertex that does not exist.
MeshReport describe(const Mesh& mesh);

/// Faces that cross or touch others where they share no vertex or edge.
struct SelfIntersections {
  /// Pairs of triangles; a quad counts as its two triangles at the corners 0 and 2.
  std::uint64_t pairs = 0;
  std::vector<Index> faces;  ///< part of a pair; ascending, triangles first, then quads
};

/// Finds all self-intersections, exactly, for the coordinates as they are. Faces without area take
/// no part; of several faces over the same vertices, only one is looked at. Takes n log n in the
/// faces unless many overlap. Throws `kInvalidMesh` if a face names a vertex that does not exist.
SelfIntersections find_self_intersections(const Mesh& mesh);

}  // namespace kdm
