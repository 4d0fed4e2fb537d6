// SPDX-License-Identifier: MIT
// What one should know before one trusts a result.
#pragma once

#include <string>
#include <vector>

namespace kdm {

/// Something that came out otherwise than one may take for granted.
struct Warning {
  /// For programs: `TOLERANCE_WIDENED`, `TOPOLOGY_UNRESOLVED`, `PARTS_LOST`, `PARTS_DROPPED`,
  /// `PARTS_TURNED`, `NESTING_UNKNOWN`, `SEWN_FAR`, `HOLES_CLOSED`, `WINDING_THRESHOLD`,
  /// `STRAY_PARTS` or `TRIANGLES_CROSS`.
  std::string code;
  std::string message;  ///< for people, with numbers
};

}  // namespace kdm
