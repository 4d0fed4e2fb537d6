// SPDX-License-Identifier: MIT
// Random closed meshes full of ties and overlaps, the same on every platform for a given seed.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kdmanifold/mesh.h"

namespace kdm::shapes {

/// Closed tetrahedra at random in the unit cube, all outwards, overlapping at will.
Mesh random_tetrahedra(int count, std::uint32_t seed);

/// Tetrahedra with corners in {0..range}^3, welded; some are inside out: coplanar faces, shared
/// and overlapping edges, faces that cancel, windings from below -1 to far above 1.
Mesh integer_tetrahedra(int count, int range, std::uint32_t seed);

/// The surface of a size^3 block whose voxels are filled with the given probability: touches
/// itself along edges and at vertices.
Mesh random_voxels(int size, double probability, std::uint32_t seed);

/// A sphere whose vertices are moved to random points of {0..range}^3 with vertices of equal
/// position welded: closed and balanced by construction, crossing itself everywhere, with
/// degenerate and doubled faces left in.
Mesh collapsed_polyhedron(int range, std::uint32_t seed);

/// Closed by construction from any bytes (for the fuzzers): each group of bytes gives a
/// tetrahedron over a grid of (up to) 64 points an axis.
Mesh mesh_from_bytes(const std::uint8_t* bytes, std::size_t size);

}  // namespace kdm::shapes
