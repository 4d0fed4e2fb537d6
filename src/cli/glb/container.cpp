// SPDX-License-Identifier: MIT
// Takes GLB files apart. cli-glb-file.ts does the same, word for word.
#include "cli/glb/container.h"

#include <fmt/format.h>

#include "kdmanifold/error.h"

namespace kdm::cli::glb {
namespace {

constexpr std::size_t kHeader = 12;      // bytes: magic, version, length
constexpr std::size_t kChunkHeader = 8;  // bytes: length, type
constexpr std::uint32_t kJsonChunk = 0x4e4f534a;
constexpr std::uint32_t kBinaryChunk = 0x004e4942;

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) {
    value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  }
  return value;
}

// Returns the bytes of the chunk at `at`, which must be of the type. Bounds are checked.
std::string_view chunk(const Container& file, std::string_view bytes, std::size_t at,
                       std::uint32_t type, const char* what) {
  if (bytes.size() - at < kChunkHeader || word_at(bytes, at + 4) != type) {
    file.fail(fmt::format("byte {}: {} should follow", at, what));
  }
  const std::uint32_t length = word_at(bytes, at);
  if (length > bytes.size() - at - kChunkHeader) {
    file.fail(fmt::format("byte {}: {} of {} bytes should follow, but the file ends at byte {}", at,
                          what, length, bytes.size()));
  }
  return bytes.substr(at + kChunkHeader, length);
}

// What says how things look, where light is, or how they move changes no mesh at rest.
bool changes_no_mesh(const std::string& extension) {
  for (const char* prefix :
       {"KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_", "KHR_lights_",
        "EXT_lights_", "KHR_animation_", "KHR_xmp", "KHR_mesh_quantization"}) {
    if (extension.rfind(prefix, 0) == 0) return true;
  }
  return false;
}

void check_extensions(const Container& file) {
  for (const Json& item : list(file, file.json, "extensionsRequired", "the JSON")) {
    if (!item.is_string()) file.fail("extensionsRequired holds what is no text");
    const std::string name = item.get<std::string>();
    if (name == "KHR_draco_mesh_compression") {
      file.fail(
          "it is compressed by KHR_draco_mesh_compression; save it without compression, as "
          "'npx @gltf-transform/cli copy IN.glb OUT.glb' does");
    }
    if (name == "EXT_meshopt_compression" || name == "KHR_meshopt_compression") {
      file.fail("it is compressed by " + name + "; save it without compression");
    }
    if (!changes_no_mesh(name)) {
      file.fail("it needs the extension " + name + ", which is not supported");
    }
  }
}

}  // namespace

void Container::fail(const std::string& message) const {
  throw Error(ErrorCode::kParseError, name + ": " + message);
}

Container open(std::string_view bytes, const std::string& name) {
  Container file{name, {}, {}};
  if (bytes.substr(0, 1) == "{") file.fail("it is a .gltf file; .glb files are supported");
  if (bytes.substr(0, 4) != "glTF") file.fail("byte 0: a GLB file begins with 'glTF'");
  if (bytes.size() < kHeader) file.fail(fmt::format("the file ends at byte {}", bytes.size()));
  if (word_at(bytes, 4) != 2) {
    file.fail(fmt::format("byte 4: it is of version {}; 2 is supported", word_at(bytes, 4)));
  }
  const std::uint32_t length = word_at(bytes, 8);
  if (length > bytes.size()) {
    file.fail(
        fmt::format("byte 8: the file should have {} bytes, but has {}", length, bytes.size()));
  }
  bytes = bytes.substr(0, std::max<std::size_t>(length, kHeader));
  const std::string_view text = chunk(file, bytes, kHeader, kJsonChunk, "a chunk of JSON");
  file.json = Json::parse(text, nullptr, false);
  if (!file.json.is_object()) file.fail("byte 20: the JSON is malformed");
  const std::size_t next = kHeader + kChunkHeader + text.size();
  if (next < bytes.size()) {
    file.binary = chunk(file, bytes, next, kBinaryChunk, "a chunk of binary data");
  }
  check_extensions(file);
  return file;
}

const Json& list(const Container& file, const Json& json, const char* key,
                 const std::string& path) {
  static const Json kEmpty = Json::array();
  const auto found = json.find(key);
  if (found == json.end()) return kEmpty;
  if (!found->is_array()) file.fail(fmt::format("{}: {} is no list", path, key));
  return *found;
}

const Json& element(const Container& file, const char* key, std::uint64_t index,
                    const std::string& user) {
  const Json& all = list(file, file.json, key, "the JSON");
  if (index >= all.size()) {
    file.fail(fmt::format("{} refers to {}[{}], but there are {}", user, key, index, all.size()));
  }
  const Json& found = all[index];
  if (!found.is_object()) file.fail(fmt::format("{}[{}] is no object", key, index));
  return found;
}

std::uint64_t whole(const Container& file, const Json& value, const std::string& path) {
  constexpr double kLargest = 9007199254740991;  // what JavaScript counts to
  const double number = value.is_number() ? value.get<double>() : -1;
  if (!(number >= 0 && number <= kLargest && number == std::floor(number))) {
    file.fail(path + " is no whole number from 0 on");
  }
  return static_cast<std::uint64_t>(number);
}

std::uint64_t whole(const Container& file, const Json& json, const char* key,
                    const std::string& path, std::uint64_t missing) {
  const auto found = json.find(key);
  return found == json.end() ? missing : whole(file, *found, path + '.' + key);
}

std::uint64_t whole(const Container& file, const Json& json, const char* key,
                    const std::string& path) {
  const auto found = json.find(key);
  return whole(file, found == json.end() ? Json() : *found, path + '.' + key);
}

}  // namespace kdm::cli::glb
