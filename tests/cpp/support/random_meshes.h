// SPDX-License-Identifier: MIT
// Random closed meshes full of ties and overlaps, the same on every platform for a given seed.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kdmanifold/mesh.h"

namespace kdm::shapes {

/// Makes random tetrahedra in the unit cube, which face outwards and may overlap.
Mesh random_tetrahedra(int count, std::uint32_t seed);

/// Makes tetrahedra with corners in {0..range}^3, welded, some of them inside out. So there are
/// coplanar faces, shared and overlapping edges, faces that cancel each other, and winding numbers
/// from below -1 to far above 1.
Mesh integer_tetrahedra(int count, int range, std::uint32_t seed);

/// Makes the surface of a block of size^3 voxels, each of which is filled with the given
/// probability. The surface touches itself along edges and at vertices.
Mesh random_voxels(int size, double probability, std::uint32_t seed);

/// Moves the vertices of a sphere to random points of {0..range}^3 and welds those of equal
/// position. The mesh uses every edge equally often in both directions, crosses itself everywhere,
/// and has degenerate and doubled faces.
Mesh collapsed_polyhedron(int range, std::uint32_t seed);

/// Makes a closed mesh of any bytes, for the fuzzers: each group of bytes gives a tetrahedron with
/// corners on a grid of up to 64 points an axis.
Mesh mesh_from_bytes(const std::uint8_t* bytes, std::size_t size);

}  // namespace kdm::shapes
