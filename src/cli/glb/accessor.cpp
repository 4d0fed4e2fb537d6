// SPDX-License-Identifier: MIT
// Reads arrays, after everything was checked that says where they lie.
#include "cli/glb/accessor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace kdm::cli::glb {
namespace {

constexpr std::uint64_t kByte = 5120, kUnsignedByte = 5121, kShort = 5122, kUnsignedShort = 5123,
                        kUnsignedInt = 5125, kFloat = 5126;
// No more elements are made of nothing: an accessor without bytes holds zeros.
constexpr std::uint64_t kMostElements = std::uint64_t{1} << 28;

std::size_t size_of(std::uint64_t type) {
  if (type == kByte || type == kUnsignedByte) return 1;
  return type == kShort || type == kUnsignedShort ? 2 : 4;
}

template <typename Number>
Number number_at(const char* at) {
  Number value;
  std::memcpy(&value, at, sizeof value);  // GLB is little endian, and so is all we run on
  return value;
}

std::uint64_t unsigned_at(const char* at, std::uint64_t type) {
  if (type == kUnsignedByte) return number_at<std::uint8_t>(at);
  if (type == kUnsignedShort) return number_at<std::uint16_t>(at);
  return number_at<std::uint32_t>(at);
}

double value_at(const char* at, std::uint64_t type, bool normalized) {
  const auto scaled = [&](double value, double most) {
    return normalized ? std::max(value / most, -1.0) : value;
  };
  if (type == kByte) return scaled(number_at<std::int8_t>(at), 127);
  if (type == kUnsignedByte) return scaled(number_at<std::uint8_t>(at), 255);
  if (type == kShort) return scaled(number_at<std::int16_t>(at), 32767);
  if (type == kUnsignedShort) return scaled(number_at<std::uint16_t>(at), 65535);
  return number_at<float>(at);
}

// Elements that lie `stride` bytes apart; all are within the file.
struct Elements {
  const char* first = nullptr;
  std::uint64_t stride = 0;
  const char* at(std::uint64_t i) const { return first + i * stride; }
};

// What elements are.
struct Kind {
  std::uint64_t type;        // of a component
  std::uint64_t components;  // of an element
  bool may_be_spaced;        // other things may lie between them
};

void check_buffer(const Container& file, std::uint64_t index, const std::string& user) {
  const Json& buffer = element(file, "buffers", index, user);
  if (index == 0 && !buffer.contains("uri")) return;
  const auto uri = buffer.find("uri");
  const bool named = uri != buffer.end() && uri->is_string();
  std::string where = named ? uri->get<std::string>() : "";
  if (where.rfind("data:", 0) == 0) where = "text";
  file.fail(fmt::format("buffers[{}] is not in the file{}; only what is in it is read", index,
                        where.empty() ? "" : " but in " + where));
}

// Finds the elements that `json` (an accessor, or a part of a sparse one) refers to.
Elements locate(const Container& file, const Json& json, const std::string& path,
                std::uint64_t count, const Kind& kind) {
  const std::uint64_t view_index = whole(file, json, "bufferView", path);
  const Json& view = element(file, "bufferViews", view_index, path);
  const std::string view_path = fmt::format("bufferViews[{}]", view_index);
  check_buffer(file, whole(file, view, "buffer", view_path), view_path);
  const std::uint64_t start = whole(file, view, "byteOffset", view_path, 0);
  const std::uint64_t length = whole(file, view, "byteLength", view_path);
  if (start > file.binary.size() || length > file.binary.size() - start) {
    file.fail(
        fmt::format("{} goes beyond the {} bytes of binary data", view_path, file.binary.size()));
  }
  const std::uint64_t component = size_of(kind.type);
  const std::uint64_t size = component * kind.components;
  const std::uint64_t given =
      kind.may_be_spaced ? whole(file, view, "byteStride", view_path, 0) : 0;
  const std::uint64_t stride = given == 0 ? size : given;
  const std::uint64_t offset = whole(file, json, "byteOffset", path, 0);
  if ((start + offset) % component != 0 || stride % component != 0) {
    file.fail(path + " is not aligned to the size of its numbers");
  }
  if (stride < size) file.fail(view_path + ".byteStride is less than an element");
  if (count > 0 && (offset > length || length - offset < size ||
                    count - 1 > (length - offset - size) / stride)) {
    file.fail(fmt::format("{} goes beyond {}", path, view_path));
  }
  return {file.binary.data() + (count > 0 ? start + offset : 0), stride};
}

struct Accessor {
  const Json& json;
  std::string path;
  std::uint64_t count;
  Kind kind;
};

Accessor find(const Container& file, std::uint64_t index, const std::string& user,
              const char* shape, std::initializer_list<std::uint64_t> types) {
  const Json& json = element(file, "accessors", index, user);
  std::string path = fmt::format("accessors[{}]", index);
  const auto given = json.find("type");
  if (given == json.end() || *given != shape) file.fail(path + ".type is not " + shape);
  const std::uint64_t type = whole(file, json, "componentType", path);
  if (std::find(types.begin(), types.end(), type) == types.end()) {
    file.fail(fmt::format("{}.componentType is {}, which cannot be here", path, type));
  }
  const std::uint64_t count = whole(file, json, "count", path);
  if (count > kMostElements) file.fail(path + ".count is too large");
  const bool points = std::string_view(shape) == "VEC3";
  return {json, std::move(path), count, {type, points ? 3u : 1u, points}};
}

// Calls `take(element, bytes)` for all elements that have bytes, the replaced ones of sparse
// accessors last.
template <typename Take>
void for_each_element(const Container& file, const Accessor& accessor, Take&& take) {
  if (accessor.json.contains("bufferView")) {
    const Elements elements =
        locate(file, accessor.json, accessor.path, accessor.count, accessor.kind);
    for (std::uint64_t i = 0; i < accessor.count; ++i) take(i, elements.at(i));
  }
  const auto sparse = accessor.json.find("sparse");
  if (sparse == accessor.json.end()) return;
  const std::string path = accessor.path + ".sparse";
  if (!sparse->is_object()) file.fail(path + " is no object");
  const std::uint64_t count = whole(file, *sparse, "count", path);
  if (count > accessor.count) file.fail(path + ".count is larger than that of the accessor");
  const auto part = [&](const char* key) -> const Json& {
    const auto found = sparse->find(key);
    if (found == sparse->end() || !found->is_object()) {
      file.fail(fmt::format("{}.{} is no object", path, key));
    }
    return *found;
  };
  const Json& places = part("indices");
  const std::uint64_t type = whole(file, places, "componentType", path + ".indices");
  if (type != kUnsignedByte && type != kUnsignedShort && type != kUnsignedInt) {
    file.fail(fmt::format("{}.indices.componentType is {}, which cannot be here", path, type));
  }
  const Elements indices = locate(file, places, path + ".indices", count, {type, 1, false});
  const Kind kind{accessor.kind.type, accessor.kind.components, false};
  const Elements values = locate(file, part("values"), path + ".values", count, kind);
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t place = unsigned_at(indices.at(i), type);
    if (place >= accessor.count) {
      file.fail(
          fmt::format("{}.indices has {}, but there are {} elements", path, place, accessor.count));
    }
    take(place, values.at(i));
  }
}

}  // namespace

std::vector<Vec3> read_points(const Container& file, std::uint64_t index, const std::string& user) {
  const Accessor accessor =
      find(file, index, user, "VEC3", {kByte, kUnsignedByte, kShort, kUnsignedShort, kFloat});
  const auto given = accessor.json.find("normalized");
  const bool normalized = given != accessor.json.end() && *given == true;
  const std::size_t size = size_of(accessor.kind.type);
  std::vector<Vec3> points(accessor.count, Vec3::Zero());
  for_each_element(file, accessor, [&](std::uint64_t i, const char* at) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      points[i][static_cast<Eigen::Index>(axis)] =
          value_at(at + axis * size, accessor.kind.type, normalized);
    }
  });
  return points;
}

std::vector<Index> read_numbers(const Container& file, std::uint64_t index,
                                const std::string& user) {
  const Accessor accessor =
      find(file, index, user, "SCALAR", {kUnsignedByte, kUnsignedShort, kUnsignedInt});
  std::vector<Index> numbers(accessor.count, 0);
  for_each_element(file, accessor, [&](std::uint64_t i, const char* at) {
    numbers[i] = static_cast<Index>(unsigned_at(at, accessor.kind.type));
  });
  return numbers;
}

}  // namespace kdm::cli::glb
