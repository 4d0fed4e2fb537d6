// SPDX-License-Identifier: MIT
// What somebody may have meant who typed a word that does not exist.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kdm::cli {

/// Returns the word that is likely meant, or "": the one that the fewest changes lead to (of
/// letters, or of two neighbours that change places; at most a third of the letters, but one
/// always), or else the first that begins with what is typed, or else has it somewhere.
std::string nearest(std::string_view typed, const std::vector<std::string>& words);

/// Returns "; did you mean WORD?", or "".
std::string did_you_mean(std::string_view typed, const std::vector<std::string>& words);

}  // namespace kdm::cli
