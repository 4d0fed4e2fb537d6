// SPDX-License-Identifier: MIT
// The header of a PLY file: which elements follow, and how each is laid out.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace kdm {

enum class PlyFormat { kAscii, kLittleEndian, kBigEndian };
enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

struct PlyProperty {
  std::string name;
  PlyType type;  ///< of the value, or of a list's items
  bool is_list = false;
  PlyType count_type = PlyType::kUint8;  ///< of a list's length
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::size_t line = 0;  ///< where the header declares it, for messages
  std::vector<PlyProperty> properties;

  /// The position of a property, or `properties.size()`.
  std::size_t find(std::string_view property) const;
  bool has_list() const;
  /// Bytes of one record in a binary file; only without lists.
  std::size_t record_bytes() const;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::kAscii;
  std::vector<PlyElement> elements;
  std::size_t bytes = 0;  ///< where the data begin
};

constexpr std::size_t ply_type_bytes(PlyType type) {
  switch (type) {
    case PlyType::kInt8:
    case PlyType::kUint8:
      return 1;
    case PlyType::kInt16:
    case PlyType::kUint16:
      return 2;
    case PlyType::kInt32:
    case PlyType::kUint32:
    case PlyType::kFloat32:
      return 4;
    case PlyType::kFloat64:
      return 8;
  }
  return 0;
}

/// Throws `kParseError` with the line.
PlyHeader parse_ply_header(std::string_view bytes, std::string_view name);

}  // namespace kdm
