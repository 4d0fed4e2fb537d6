// SPDX-License-Identifier: MIT
// The formats of files that command lines read and write: those of the library, and GLB.
#pragma once

#include <string>
#include <string_view>

#include "kdmanifold/options.h"

namespace kdm::cli {

/// What a file is.
enum class FileFormat { kByName, kObj, kStl, kPly, kOff, kGlb };

inline constexpr std::array kFileFormatWords = {
    Word{"obj", FileFormat::kObj, "Wavefront OBJ"}, Word{"stl", FileFormat::kStl, "STL"},
    Word{"ply", FileFormat::kPly, "PLY"}, Word{"off", FileFormat::kOff, "OFF"},
    Word{"glb", FileFormat::kGlb, "binary glTF"}};

/// Standard input or standard output, as a path.
inline constexpr std::string_view kStandardStream = "-";

/// Returns what messages call a file.
std::string input_name(const std::string& path);

/// Returns the format of an input: `chosen`, or else what the extension (any case) stands for.
/// Throws `Error` for other names.
FileFormat input_format(const std::string& path, FileFormat chosen);
/// Returns the format of a result. See above.
FileFormat output_format(const std::string& path, FileFormat chosen);

/// Returns the library's name for a format that is not GLB.
MeshFormat library_format(FileFormat format);

/// Returns the last part of a path, without its folder.
std::string_view file_name(std::string_view path);

}  // namespace kdm::cli

namespace kdm {

/// Returns the words of the formats. `kByName` has none.
template <>
constexpr std::span<const Word<cli::FileFormat>> words_of<cli::FileFormat>() {
  return cli::kFileFormatWords;
}

}  // namespace kdm
