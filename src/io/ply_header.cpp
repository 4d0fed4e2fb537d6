// SPDX-License-Identifier: MIT
// Reads the header of a PLY file.
#include "io/ply_header.h"

#include "io/text_scanner.h"
#include "text/compose.h"
#include "text/lower_case.h"

namespace kdm {
namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr TypeName kTypeNames[] = {
    {"char", PlyType::kInt8},       {"int8", PlyType::kInt8},       {"uchar", PlyType::kUint8},
    {"uint8", PlyType::kUint8},     {"short", PlyType::kInt16},     {"int16", PlyType::kInt16},
    {"ushort", PlyType::kUint16},   {"uint16", PlyType::kUint16},   {"int", PlyType::kInt32},
    {"int32", PlyType::kInt32},     {"uint", PlyType::kUint32},     {"uint32", PlyType::kUint32},
    {"float", PlyType::kFloat32},   {"float32", PlyType::kFloat32}, {"double", PlyType::kFloat64},
    {"float64", PlyType::kFloat64}, {"int64", PlyType::kInt64},     {"uint64", PlyType::kUint64},
    {"long", PlyType::kInt64},      {"ulong", PlyType::kUint64}};

// Returns the next word of the line in lower case: no word of a header depends on its case.
std::string take_word(TextScanner& scanner) { return lower_case(scanner.word()); }

PlyType read_type(TextScanner& scanner) {
  const TextScanner start = scanner;
  const std::string word = take_word(scanner);
  for (const TypeName& known : kTypeNames) {
    if (known.name == word) return known.type;
  }
  start.fail_expected("a type such as 'float' or 'int'");
}

std::string read_name(TextScanner& scanner, const char* what) {
  std::string word = take_word(scanner);
  if (word.empty()) scanner.fail_expected(what);
  return word;
}

PlyFormat read_format(TextScanner& scanner) {
  const TextScanner start = scanner;
  const std::string word = take_word(scanner);
  if (word == "ascii") return PlyFormat::kAscii;
  if (word == "binary_little_endian") return PlyFormat::kLittleEndian;
  if (word == "binary_big_endian") return PlyFormat::kBigEndian;
  start.fail_expected("'ascii', 'binary_little_endian' or 'binary_big_endian'");
}

PlyProperty read_property(TextScanner& scanner) {
  PlyProperty property;
  TextScanner ahead = scanner;
  if (take_word(ahead) == "list") {
    scanner = ahead;
    property.is_list = true;
    property.count_type = read_type(scanner);
    if (!is_integer(property.count_type)) {
      scanner.fail("a list cannot be counted in a floating-point type");
    }
  }
  property.type = read_type(scanner);
  property.name = read_name(scanner, "the property's name");
  return property;
}

PlyElement read_element(TextScanner& scanner) {
  PlyElement element;
  element.line = scanner.line();
  element.name = read_name(scanner, "the element's name");
  const std::int64_t count = scanner.integer("the number of elements");
  if (count < 0) scanner.fail(compose("the number of elements is {}, below 0", count));
  element.count = static_cast<std::uint64_t>(count);
  return element;
}

}  // namespace

std::size_t PlyElement::find(std::string_view property) const {
  std::size_t i = 0;
  while (i < properties.size() && properties[i].name != property) ++i;
  return i;
}

bool PlyElement::has_list() const {
  for (const PlyProperty& property : properties) {
    if (property.is_list) return true;
  }
  return false;
}

std::size_t PlyElement::record_bytes() const {
  std::size_t bytes = 0;
  for (const PlyProperty& property : properties) bytes += ply_type_bytes(property.type);
  return bytes;
}

PlyHeader parse_ply_header(std::string_view bytes, std::string_view name) {
  TextScanner scanner(bytes, name);
  const TextScanner start = scanner;
  if (take_word(scanner) != "ply") start.fail_expected("the keyword 'ply'");
  scanner.skip_line();
  PlyHeader header;
  bool has_format = false;
  while (true) {
    scanner.find_word();
    const TextScanner statement = scanner;
    const std::string keyword = take_word(scanner);
    if (keyword == "end_header") break;
    if (keyword == "format") {
      header.format = read_format(scanner);
      has_format = true;
    } else if (keyword == "element") {
      header.elements.push_back(read_element(scanner));
    } else if (keyword == "property") {
      if (header.elements.empty()) statement.fail("a property before the first element");
      header.elements.back().properties.push_back(read_property(scanner));
    } else if (keyword != "comment" && keyword != "obj_info") {
      statement.fail_expected("'element', 'property' or 'end_header'");
    }
    scanner.skip_line();
  }
  if (!has_format) scanner.fail("the header has no 'format' line");
  scanner.skip_line();
  header.bytes = scanner.offset();
  return header;
}

}  // namespace kdm
