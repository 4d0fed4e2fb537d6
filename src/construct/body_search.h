// SPDX-License-Identifier: MIT
// Finds the thin bodies of a closed surface: parts that are not much thicker than the tolerance.
#pragma once

#include <optional>
#include <vector>

#include "mesh/marks.h"
#include "mesh/nesting.h"
#include "prepare/surface.h"

namespace kdm {

/// The parts of a closed surface, and the bodies that they form: a part and the cavities that leave
/// a thin wall of it.
struct Bodies {
  std::vector<Index> part_of;         ///< per triangle
  std::vector<int> sign;              ///< per part: of its volume; 0 if it encloses nothing
  std::vector<Index> body_of_part;    ///< per part
  Marks thin;                         ///< per body
  std::vector<Enclosure> enclosures;  ///< which part lies in which, ascending

  Index parts() const { return static_cast<Index>(sign.size()); }
};

/// Tells whether a body is thin all over, by its volume, its area and its bounding box.
/// `tolerance` is in model units, like all of these.
bool is_thin(double volume, double area, const Box& bounds, double tolerance);

/// Returns the bodies of a surface without rims, if one of them is thin (see exact_parts.h) and it
/// can be told which parts lie in which. `tolerance` is in model units. Where no part can be thin,
/// this takes one pass over the triangles.
std::optional<Bodies> find_thin_bodies(const Surface& surface, double tolerance);

}  // namespace kdm
