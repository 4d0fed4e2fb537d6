// SPDX-License-Identifier: MIT
// Makes solids of the parts of a surface that neither sewing nor patches close.
#pragma once

#include "kdmanifold/build.h"
#include "kdmanifold/progress.h"
#include "prepare/faces.h"

namespace kdm {

/// Tells whether some part of the faces is closed: parts are joined by sides that are opposite to
/// each other.
bool some_part_is_closed(const InputFaces& faces);

/// Puts closed surfaces in the place of all parts that are not closed, so that the faces bound a
/// solid. These parts are built and extracted together, without the closed ones, within the
/// tolerance, or half of it if there are no others: winding numbers tell inside from outside there,
/// and if the tolerance has to be widened, it is widened for them alone. The closed parts stay as
/// they are. Parts that enclose nothing are left out; the report counts those of them that do not
/// lie inside of others. Throws `kNotClosed` if nothing is left. Returns the winding number above
/// which points were inside; 0 if none had to be asked for.
double solidify_open_parts(InputFaces& faces, const BuildOptions& options,
                           const Progress& progress);

}  // namespace kdm
