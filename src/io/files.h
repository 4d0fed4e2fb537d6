// SPDX-License-Identifier: MIT
// Reads and writes whole files.
#pragma once

#include <string>
#include <string_view>

namespace kdm {

/// Returns the bytes of a file. Throws `kIoError` if it cannot be read.
std::string read_file(const std::string& path);

/// Writes a file, which appears complete or not at all: it is written under another name in the
/// same folder and then renamed. Throws `kIoError` if that fails; nothing is left behind then.
void write_file(const std::string& path, std::string_view bytes);

}  // namespace kdm
