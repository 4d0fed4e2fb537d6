// SPDX-License-Identifier: MIT
// Whole files in and out.
#pragma once

#include <string>
#include <string_view>

namespace kdm {

/// Throws `kIoError`.
std::string read_file(const std::string& path);

/// The file appears complete or not at all: it is written under another name beside its place.
/// Throws `kIoError`.
void write_file(const std::string& path, std::string_view bytes);

}  // namespace kdm
