// SPDX-License-Identifier: MIT
// Moves vertices of an embedded mesh back to the surface, after refining has moved them off it.
#pragma once

#include <vector>

#include "extract/embed/crossing_pairs.h"

namespace kdm {

/// A vertex, where it is, and where it would better be; lattice units.
struct MovedVertex {
  VertexId vertex;
  Vec3 position;
  Vec3 better;
};

/// Moves all these vertices to where they would better be; then puts those back whose triangles
/// cross others there, until no triangle of one that has moved does.
void move_unless_crossing(const std::vector<MovedVertex>& moved, CrossingPairs& crossing_pairs,
                          DualMesh& mesh);

/// Returns how far the point is from the planes of the hits round a vertex, at most.
double furthest_plane(const GridView& view, const DualMesh& mesh, VertexId v, const Vec3& point);

/// Finds vertices of links that are further than `distance` (lattice units) from the planes of
/// their hits, and for each the point of its minimal face where it would be if nothing crossed
/// there. `mesh` was made from `loops`.
std::vector<MovedVertex> find_links_off_planes(const GridView& view, const DualMesh& loops,
                                               double distance, const DualMesh& mesh);

}  // namespace kdm
