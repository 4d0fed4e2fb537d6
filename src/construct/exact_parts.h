// SPDX-License-Identifier: MIT
// Takes thin parts out of a surface before it is divided into cells, so that they are in the result
// just as they are in the input.
//
// Cells that are wider than a wall is thick lose some of the wall, and cells that are as small take
// far more triangles than the wall has: a wire has as many stretches of its thickness as there are
// in its length. But a wall that meets nothing needs no cells, since there is nothing to decide
// about it.
#pragma once

#include "inside/solid_states.h"
#include "kdmanifold/build.h"
#include "kdmanifold/mesh.h"
#include "prepare/surface.h"

namespace kdm {

/// What was found out about the thin parts of a surface.
struct ExactParts {
  Mesh mesh;  ///< the parts that were taken out, in model units; coordinates are 32-bit floats
  Index parts = 0;    ///< how many these are
  Index inexact = 0;  ///< further thin parts, which stay in the surface
};

/// Takes closed parts out of the surface that are thin, and whose place in the result is sure
/// without any cells. A part together with the cavities in it is thin if its volume is less than
/// its area times one and a half tolerances (a plate of three tolerances has that), and it is at
/// least eight times as long as it is thick. Its place is sure if
/// - it is a 2-manifold by itself and shares no vertex with others,
/// - it bounds the solid all over, by the states round it: of several solids these stand for their
///   winding numbers, so that it is the result that counts,
/// - its triangles have areas and meet no others, with coordinates rounded to 32 bits,
/// - parts that stay lie further from it than two tolerances, and not within it.
///
/// Takes nothing out of surfaces with rims, nor where the options go by depth or cells.
/// `states` are those of the surface's solids, or of the one solid that it is. Without thin parts
/// this takes one pass over the triangles.
ExactParts take_exact_parts(Surface& surface, SolidStates& states, const BuildOptions& options);

}  // namespace kdm
