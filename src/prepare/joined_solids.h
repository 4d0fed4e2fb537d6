// SPDX-License-Identifier: MIT
// Several solids, each prepared by itself, as one surface on one lattice.
#pragma once

#include <memory>
#include <vector>

#include "kdmanifold/build.h"
#include "prepare/surface.h"

namespace kdm {

/// A solid of a Boolean operation: its faces form closed surfaces.
struct SolidFaces {
  InputFaces faces;
  InsideRule inside = InsideRule::kPositive;
  Index operand = kNone;  ///< what its number is for the user; kNone: it was invented
  /// The faces on a lattice, if they were joined before.
  std::shared_ptr<const Surface> rounded = nullptr;
};

/// Whether `SolidFaces::rounded` is filled, for solids that are joined again.
enum class Rounded { kDropped, kKept };

/// The solids as one surface, and what each of them is.
struct JoinedSolids {
  Surface surface;                ///< `solid_of` and `operand_of_solid` are filled
  std::vector<InsideRule> rules;  ///< per solid
  /// Per element of the list that was given: the number of the solid that it is. Those that are
  /// equal to others are the same.
  std::vector<Index> solid_of_given;
};

/// Joins solids. Those with the same points, triangles and rule count once, and the others are
/// numbered by what they are like, so that the surface does not depend on the order in which they
/// are given. They are rounded to the lattice that the options ask for. The reports in `given` are
/// completed; faces that need not be kept are gone. Takes time linear in the faces, but for
/// comparing solids with each other.
JoinedSolids join_solids(std::vector<SolidFaces>& given, const BuildOptions& options,
                         Rounded rounded = Rounded::kDropped);

/// Returns what reports say together: sums, and what holds for all of them.
InputReport sum_of(std::span<const InputReport> reports);

}  // namespace kdm
