// SPDX-License-Identifier: MIT
// Makes one thin part of thin parts that cross or touch, such as the bars of a basket.
//
// A thin part that meets nothing is taken over as it is (see construct/exact_parts.h). Parts that
// meet have to go through cells, and cells as wide as the tolerance tear what is thinner.
#pragma once

#include "kdmanifold/build.h"
#include "kdmanifold/progress.h"
#include "prepare/faces.h"

namespace kdm {

/// Puts unions in the places of thin closed parts that meet (see csg/thin_groups.h). Each group is
/// built by itself, within an eighth of its thickness, so that its union is a thin part that meets
/// nothing. A group whose union is empty, not thin, or has triangles that cross, stays as it is.
/// The report counts the parts that went among the rebuilt ones.
///
/// Does nothing unless the faces are closed, winding numbers above 0 are inside, no part is inside
/// out where that is left so, and the options go by a tolerance, set no depth, and do not open or
/// close.
void unite_thin_parts(InputFaces& faces, const BuildOptions& options, const Progress& progress);

}  // namespace kdm
