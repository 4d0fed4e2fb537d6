// SPDX-License-Identifier: MIT
// Names for the numbers by which everything in the flat arrays is known.
#pragma once

#include "kdmanifold/types.h"

namespace kdm {

// Of a mesh.
using PointId = Index;     ///< a position, which several faces share
using TriangleId = Index;  ///< a face of the input that construction sees
using SideId = Index;      ///< a side of an input triangle, or its first corner: mesh/sides.h

/// The source face of triangles that close holes of the input. They have planes of their own,
/// unlike hits that are invented where there is no triangle (kNone). Results say kNone for both.
inline constexpr Index kPatch = kNone - 1;

// Of a grid; grid/grid_data.h has the sketch.
using CellId = Index;      ///< a node of the kd-tree; 0 is the root
using SplitId = Index;     ///< an inner cell by the order in which the splits were made
using EdgeId = Index;      ///< splitting edge 4k + i of split k
using HitId = Index;       ///< an intersection of the surface with a grid edge
using HalfEdgeId = Index;  ///< half-edge 3h + slot of hit h, or 3t + place of a dual triangle t
using PlaneId = Index;     ///< the plane that hits share

// Of a dual mesh, which is made from a grid.
using LoopId = Index;    ///< a vertex that a loop of half-edges became
using VertexId = Index;  ///< any vertex: the loops, then those that were inserted

}  // namespace kdm
