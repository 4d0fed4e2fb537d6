// SPDX-License-Identifier: MIT
// Calls of the caller's progress function, which may ask to stop.
#pragma once

#include <cmath>
#include <string_view>

#include "kdmanifold/error.h"
#include "kdmanifold/progress.h"

namespace kdm {

/// Tells the caller which fraction (0 to 1) of the call's work is done, and in which phase it is.
/// Throws `kAborted` if the caller answers that the work is to stop. Does nothing if `progress` is
/// empty.
inline void report_progress(const Progress& progress, double fraction, std::string_view phase) {
  if (progress && !progress(fraction, phase)) {
    throw Error(ErrorCode::kAborted, "stopped by the progress callback");
  }
}

/// Makes the progress function of a step that is one part of the work: what the step reports as 0
/// to 1 reaches `whole` as `from` to `to`. It is empty if `whole` is, and refers to `whole`, which
/// must outlive it.
inline Progress part_of_progress(const Progress& whole, double from, double to) {
  if (!whole) return {};
  return [&whole, from, to](double fraction, std::string_view phase) {
    return whole(std::lerp(from, to, fraction), phase);
  };
}

}  // namespace kdm
