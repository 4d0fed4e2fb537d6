// SPDX-License-Identifier: MIT
// How far two surfaces are apart.
#pragma once

namespace kdm {

/// How far points of one surface are from another, in model units.
struct Deviation {
  double largest = 0;
  double rms = 0;  ///< root of the mean square over the area
};

/// How far a result and its input are apart; infinitely, if one of them has no area.
struct MeshError {
  Deviation to_input;   ///< of the result's points from the input
  Deviation to_output;  ///< of the input's points from the result
};

}  // namespace kdm
