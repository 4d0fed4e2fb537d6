// SPDX-License-Identifier: MIT
// Converts a solid and holds the results against its account.
#pragma once

#include <array>
#include <bitset>
#include <string>

#include "truth/solid.h"

namespace kdm::truth {

/// What may be wrong with a result.
enum Check : std::size_t {
  kThrows,      ///< an error, though the solid encloses something
  kFaulty,      ///< not closed, oriented and 2-manifold, or a triangle without area (`embedded`)
  kVolume,      ///< the volume is off by more than tolerance x area
  kFalseClaim,  ///< `topology_resolved`, and the topology is none that is allowed
  kCrossing,    ///< `embedded`, and triangles cross
  kFar,         ///< a vertex is further than 1.5 tolerances from input and solid
  kMissing,     ///< a point of the solid's surface is further than that from the result
  kSilent,      ///< wrong volume or missing surface, and no warning
  kAccount,     ///< area is said to be lost, and none is; or `error` is less than the check finds
  kInexact,     ///< of an expression: the volume is off by more than 1e-4 of itself and an eighth
                ///< of tolerance x area
  kChecks
};

/// A short name for tables.
const char* check_name(std::size_t check);

struct Verdict {
  std::bitset<kChecks> failed;
  bool topology_right = false;     ///< of both results, whatever is claimed
  bool manifold_right = false;     ///< all of the result without `embedded`
  bool topology_resolved = false;  ///< what the library says
  bool warned = false;
  double triangles = 0;  ///< of the result, by those of the input
  double volume = 0;     ///< how far the volume is off, by tolerance x area
  double far = 0;        ///< the largest distance that was too far, in tolerances
  double missing = 0;
  double seconds = 0;  ///< the library's
  std::string words;   ///< all of it for people, one line an oddity

  bool right() const { return failed.none() && topology_right; }
};

/// Builds the grid, extracts with `manifold` and `embedded`, and checks both results; of an
/// expression, that of `boolean` too.
Verdict judge(const Solid& solid);

}  // namespace kdm::truth
