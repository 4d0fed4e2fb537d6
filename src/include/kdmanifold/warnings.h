// SPDX-License-Identifier: MIT
// What one should know before one trusts a mesh that was read, or a result.
#pragma once

#include <string>
#include <vector>

namespace kdm {

/// Something that came out otherwise than one may take for granted.
struct Warning {
  /// For programs. Of files: `FACES_SKIPPED`, `FACETS_MISCOUNTED` or, of GLB files, `NOT_READ`. Of
  /// results: `AREA_LOST`, `FAR_FROM_INPUT`, `TOLERANCE_WIDENED`, `TOPOLOGY_UNRESOLVED`,
  /// `PARTS_LOST`, `PARTS_DROPPED`, `CAVITIES_FILLED`, `HANDLES_REMOVED`, `HANDLES_KEPT`,
  /// `THIN_REMOVED`, `GAPS_FILLED`, `PARTS_TURNED`, `NESTING_UNKNOWN`, `SEWN_FAR`, `HOLES_CLOSED`,
  /// `WINDING_THRESHOLD`, `STRAY_PARTS`, `THIN_PARTS`, `THIN_PARTS_EXACT` or `TRIANGLES_CROSS`.
  std::string code;
  std::string message;  ///< for people, with numbers

  bool operator==(const Warning&) const = default;
};

}  // namespace kdm
