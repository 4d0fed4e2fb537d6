// SPDX-License-Identifier: MIT
// A GLB file: a JSON text that describes a scene, and the bytes of its arrays.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace kdm::cli::glb {

using Json = nlohmann::json;

/// The two parts of a file. The bytes are those of the file, which must outlive this.
struct Container {
  std::string name;  ///< what messages call the file
  Json json;
  std::string_view binary;  ///< empty if there is none

  /// Throws `kParseError` with the name of the file.
  [[noreturn]] void fail(const std::string& message) const;
};

/// Takes the file apart. Throws `kParseError` if it is none, or if it needs what is not supported
/// here, as compressed meshes are not.
Container open(std::string_view bytes, const std::string& name);

/// Returns a member of `json` that must be a list or missing; `path` is what messages call `json`.
const Json& list(const Container& file, const Json& json, const char* key, const std::string& path);

/// Returns element `index` of a list at the top, which must be an object. `user` refers to it.
const Json& element(const Container& file, const char* key, std::uint64_t index,
                    const std::string& user);

/// Returns a member that must be a whole number; `missing` if there is none.
std::uint64_t whole(const Container& file, const Json& json, const char* key,
                    const std::string& path, std::uint64_t missing);
/// The same, but it must be there.
std::uint64_t whole(const Container& file, const Json& json, const char* key,
                    const std::string& path);
/// The same for a number that stands by itself.
std::uint64_t whole(const Container& file, const Json& value, const std::string& path);

}  // namespace kdm::cli::glb
