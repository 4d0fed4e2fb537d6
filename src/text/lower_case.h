// SPDX-License-Identifier: MIT
// Text without capital letters.
#pragma once

#include <string>
#include <string_view>

namespace kdm {

/// Returns the text with a to z in the place of A to Z, whatever the locale.
std::string lower_case(std::string_view text);

}  // namespace kdm
