// SPDX-License-Identifier: MIT
// Finds formats by names.
#include "cli/file_format.h"

#include <fmt/format.h>

#include "cli/suggest.h"
#include "kdmanifold/error.h"

namespace kdm::cli {
namespace {

// In lower case, without its dot; empty: there is none.
std::string extension_of(std::string_view path) {
  const std::string_view file = file_name(path);
  const std::size_t dot = file.rfind('.');
  std::string extension;
  if (dot != std::string_view::npos) extension = file.substr(dot + 1);
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return extension;
}

std::string hint(const std::string& extension, const char* option) {
  if (extension == "gltf") return "; .gltf files are not supported, .glb files are";
  if (extension == "kdgrid") return "; --save-grid keeps grids";
  std::vector<std::string> words;
  for (const Word<FileFormat>& word : words_of<FileFormat>()) words.emplace_back(word.word);
  const std::string near = extension.empty() ? "" : nearest(extension, words);
  if (!near.empty()) return fmt::format("; did you mean .{}?", near);
  return fmt::format("; {} tells the format of other names", option);
}

FileFormat format_of(const std::string& path, FileFormat chosen, const char* stream,
                     const char* option) {
  if (chosen != FileFormat::kByName) return chosen;
  if (path == kStandardStream) {
    throw Error(ErrorCode::kIoError,
                fmt::format("{} has no name that tells its format; {} does", stream, option));
  }
  const std::string extension = extension_of(path);
  if (const auto format = value_of<FileFormat>(extension)) return *format;
  throw Error(ErrorCode::kIoError,
              fmt::format("{}: the file's name ends in none of .obj, .stl, .ply, .off and .glb{}",
                          path, hint(extension, option)));
}

}  // namespace

std::string input_name(const std::string& path) {
  return path == kStandardStream ? "standard input" : path;
}

FileFormat input_format(const std::string& path, FileFormat chosen) {
  return format_of(path, chosen, "standard input", "--input-format");
}

FileFormat output_format(const std::string& path, FileFormat chosen) {
  return format_of(path, chosen, "standard output", "--format");
}

MeshFormat library_format(FileFormat format) {
  return value_of<MeshFormat>(word_of(format)).value();
}

std::string_view file_name(std::string_view path) {
  const std::size_t slash = path.find_last_of("/\\");
  return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

}  // namespace kdm::cli
