// SPDX-License-Identifier: MIT
// Normals at the corners of the triangles, for shading.
#pragma once

#include "extract/dual/dual_mesh.h"

namespace kdm {

/// Cosine of an angle from 0 to 180 degrees, to 1e-15 and with the same bits on every platform,
/// which the standard library's does not promise.
double cosine_of_degrees(double degrees);

/// Per half-edge: the normal at the corner where it starts. The triangles round a vertex fall into
/// sections between creases, links across which the hits' normals turn by more than the angle with
/// this cosine; all corners of a section have one normal, the average of its hits', weighted by the
/// sine of half the corner's angle. Nothing is averaged over a boundary. Half-edges of dropped
/// triangles get zeros. Linear.
std::vector<Vec3> corner_normals(const GridData& grid, const DualMesh& mesh, double crease_cosine);

}  // namespace kdm
