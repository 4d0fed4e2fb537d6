// SPDX-License-Identifier: MIT
// Reads the header of a PLY file, which says what data follow it. They are elements (such as the
// vertices, or the faces); an element is a list of records that all have the same properties.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace kdm {

/// How the data behind the header are written.
enum class PlyFormat { kAscii, kLittleEndian, kBigEndian };
/// The types that a value can have.
enum class PlyType {
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat32,
  kFloat64
};

/// A value, or a list of values, of each record of an element.
struct PlyProperty {
  std::string name;  ///< in lower case
  PlyType type;      ///< type of the value, or of the items of the list
  bool is_list = false;
  PlyType count_type = PlyType::kUint8;  ///< type of the list's length
};

/// A kind of record, and how many there are.
struct PlyElement {
  std::string name;  ///< in lower case
  std::uint64_t count = 0;
  std::size_t line = 0;  ///< where the header declares it, for messages
  std::vector<PlyProperty> properties;

  /// Returns the place of the property with this name, or `properties.size()` if there is none.
  std::size_t find(std::string_view property) const;
  /// Tells whether a property is a list, so that records differ in length.
  bool has_list() const;
  /// Returns how many bytes a record has in a binary file. No property may be a list.
  std::size_t record_bytes() const;
};

/// What a header says.
struct PlyHeader {
  PlyFormat format = PlyFormat::kAscii;
  std::vector<PlyElement> elements;  ///< in the order of the file
  std::size_t bytes = 0;             ///< where the data begin
};

/// Returns how many bytes a value of a type has in a binary file.
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
    case PlyType::kInt64:
    case PlyType::kUint64:
    case PlyType::kFloat64:
      return 8;
  }
  return 0;
}

/// Tells whether values of a type are whole numbers.
constexpr bool is_integer(PlyType type) {
  return type != PlyType::kFloat32 && type != PlyType::kFloat64;
}

/// Reads the header at the beginning of a file, which messages call `name`. Throws `kParseError`
/// with the line at fault.
PlyHeader parse_ply_header(std::string_view bytes, std::string_view name);

}  // namespace kdm
