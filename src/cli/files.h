// SPDX-License-Identifier: MIT
// Files and standard streams, read and written whole, with the words of both command lines.
#pragma once

#include <string>
#include <string_view>

namespace kdm::cli {

/// Returns the bytes of a file, or those of standard input for `-`. Throws `Error`.
std::string read_all(const std::string& path);

/// Throws `Error` if the path is a folder, or a file that exists while `force` is not set.
void check_target(const std::string& path, bool force);

/// Throws `Error` unless the file can be made in its folder.
void check_folder_of(const std::string& path);

/// Throws `Error` unless files can be made in the folder, or the folder in its parent. `subject`
/// begins the message.
void check_folder(const std::string& folder, const std::string& subject);

/// Writes a file, which appears complete or not at all, even if SIGINT or SIGTERM come: it is
/// written under another name in its folder and then renamed. Devices and pipes are written as they
/// are, `-` is standard output. Throws `Error`.
void write_all(const std::string& path, std::string_view bytes);

/// Makes the folder unless it is there. Throws `Error`.
void make_folder(const std::string& folder);

}  // namespace kdm::cli
