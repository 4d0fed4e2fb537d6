// SPDX-License-Identifier: MIT
// Patterns of file names that no shell has expanded: quoted ones, and all of them on Windows.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kdm::cli {

/// Says whether the text has `*`, `?` or `[`.
bool is_pattern(std::string_view text);

/// Says whether a name without folders fits a pattern: `*` is any text, `?` any character, `[a-z]`
/// one of these, `[!a-z]` one of all others. A name that begins with a dot wants one in the
/// pattern.
bool fits(std::string_view name, std::string_view pattern);

/// Returns the paths of all files that fit, in the order of their bytes. `**` between slashes is
/// any number of folders, even none; what cannot be read is passed over.
std::vector<std::string> expand(const std::string& pattern);

}  // namespace kdm::cli
