// SPDX-License-Identifier: MIT
// How far two surfaces are apart, for benchmark tables; not part of the library.
#pragma once

#include <vector>

#include "kdmanifold/mesh.h"

namespace kdm::bench {

/// Over points spread evenly on one surface: the distance to the nearest point of the other.
struct Distance {
  double max = 0;
  double mean = 0;
  double rms = 0;
};

/// From `samples` points on `from`'s faces, and from all its vertices, to `to`. Deterministic.
Distance one_sided_distance(const Mesh& from, const Mesh& to, Index samples);

/// From given points; of no points all distances are 0. Triangles may be segments or points.
Distance distance_of_points(const std::vector<Vec3>& points, const Mesh& to);

/// The distance of each point from the mesh, whose triangles may be segments or points; infinite if
/// it has none.
std::vector<double> distances_of_points(const std::vector<Vec3>& points, const Mesh& to);

/// Triangles of a mesh whose quads have been cut in two.
std::vector<Triangle> all_triangles(const Mesh& mesh);

/// Length of the diagonal of the box round all positions.
double diagonal(const Mesh& mesh);

}  // namespace kdm::bench
