// SPDX-License-Identifier: MIT
// Computes normals at the corners of the triangles, for shading.
#pragma once

#include <span>
#include <vector>

#include "extract/dual/dual_mesh.h"

namespace kdm {

/// Returns the cosine of an angle from 0 to 180 degrees, exact to 1e-15 and with the same bits on
/// every platform, which the cosine of the standard library does not guarantee.
double cosine_of_degrees(double degrees);

/// Returns for each half-edge the normal at the corner where it starts. The triangles round a
/// vertex fall into sections between creases, links across which the normals of the faces turn by
/// more than the angle with this cosine; all corners of a section have one normal, the average of
/// the normals of its faces, weighted by the sine of half the corner's angle. Nothing is averaged
/// over a boundary. Half-edges of dropped triangles get zeros. Linear. `face_normals` has one entry
/// a triangle.
std::vector<Vec3> corner_normals(const DualMesh& mesh, std::span<const Vec3> face_normals,
                                 double crease_cosine);

/// The same with the normals of the hits that the triangles stand for.
std::vector<Vec3> corner_normals(const GridData& grid, const DualMesh& mesh, double crease_cosine);

}  // namespace kdm
