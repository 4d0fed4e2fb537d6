// SPDX-License-Identifier: MIT
// Open surfaces for tests, and how far two of them and their rims are apart.
#pragma once

#include "support/shapes.h"

namespace kdm::shapes {

/// The graph of a function over the unit square, nx by ny quads cut in two, normals up.
Mesh grid_sheet(int nx, int ny, const std::function<double(double, double)>& height);
/// The same without the quads for which `missing(i, j)`.
Mesh grid_sheet(int nx, int ny, const std::function<double(double, double)>& height,
                const std::function<bool(int, int)>& missing);
/// A band with half a turn: not orientable, so neighbours somewhere run the same way.
Mesh moebius_band(int segments);
/// A tube about z without ends.
Mesh tube(double radius, double height, int segments);

struct OpenShape {
  std::string name;
  Mesh mesh;
  int components;
  int loops;
  int euler;
};
inline void PrintTo(const OpenShape& shape, std::ostream* stream) { *stream << shape.name; }

std::vector<OpenShape> open_shapes();

}  // namespace kdm::shapes

namespace kdm::check {

/// Largest distance from points all over `from`, rim included, to the faces of `to`. Every pair is
/// looked at.
double distance_to(const Mesh& from, const Mesh& to);
/// The same from the rim of one to the rim of the other.
double rim_distance_to(const Mesh& from, const Mesh& to);

}  // namespace kdm::check
