// SPDX-License-Identifier: MIT
// Open surfaces for tests, and measures of how far two surfaces and their rims are apart.
#pragma once

#include "support/shapes.h"

namespace kdm::shapes {

/// Makes the graph of a function over the unit square, from nx by ny quads cut in two. Normals
/// point up.
Mesh grid_sheet(int nx, int ny, const std::function<double(double, double)>& height);
/// Makes the same without the quads for which `missing(i, j)`.
Mesh grid_sheet(int nx, int ny, const std::function<double(double, double)>& height,
                const std::function<bool(int, int)>& missing);
/// Makes a band with half a turn. It cannot be oriented, so neighbours disagree somewhere.
Mesh moebius_band(int segments);
/// Makes a tube about the z axis that is open at both ends.
Mesh tube(double radius, double height, int segments);

/// An open surface with what is known about it.
struct OpenShape {
  std::string name;
  Mesh mesh;
  int components;
  int loops;  ///< of its boundary
  int euler;  ///< its Euler characteristic
};
/// Tells GoogleTest how to name a shape in messages.
inline void PrintTo(const OpenShape& shape, std::ostream* stream) { *stream << shape.name; }

/// Returns open surfaces of many kinds.
std::vector<OpenShape> open_shapes();

}  // namespace kdm::shapes

namespace kdm::check {

/// Returns the largest distance of points all over `from`, its rim included, to the faces of `to`.
/// It compares every point with every face that may be the nearest one.
double distance_to(const Mesh& from, const Mesh& to);
/// Returns the largest distance of points on the rim of `from` to the rim of `to`.
double rim_distance_to(const Mesh& from, const Mesh& to);

}  // namespace kdm::check
