// SPDX-License-Identifier: MIT
// How calls that take long report what is done, and how they are stopped.
#pragma once

#include <functional>
#include <string_view>

namespace kdm {

/// Called with the fraction done (0 to 1, never falling) and the name of the phase, at bounded
/// intervals and on the calling thread. Return false to stop: the call then throws `kAborted`.
using Progress = std::function<bool(double fraction, std::string_view phase)>;

}  // namespace kdm
