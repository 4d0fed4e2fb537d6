// SPDX-License-Identifier: MIT
// Numbers as people read them.
#pragma once

#include <string>

namespace kdm {

/// Writes a number that is not negative with three digits, or all of those before the point:
/// "0.0123", "2.35", "1235".
std::string rounded(double value);

}  // namespace kdm
