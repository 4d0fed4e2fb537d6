// SPDX-License-Identifier: MIT
// PLY (Stanford polygon format). Reads ASCII and binary files of either byte order, with polygons
// or triangle strips, and passes over other elements and properties. Writes binary files.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "io/bytes.h"
#include "io/decode_text.h"
#include "io/formats.h"
#include "io/mesh_builder.h"
#include "io/ply_header.h"
#include "io/text_scanner.h"
#include "text/compose.h"

namespace kdm {
namespace {

constexpr const char* kAxisNames[] = {"x", "y", "z"};

// TextValues and BinaryValues take the values behind the header one by one, from text or from
// bytes. They have the same functions, and `PlyReader` is compiled for each.
class TextValues {
 public:
  TextValues(std::string_view bytes, std::string_view name, const PlyHeader& header)
      : scanner_(bytes, name) {
    while (scanner_.offset() < header.bytes) scanner_.skip_line();
  }

  double coordinate(PlyType, const char* what) {
    find(what);
    return scanner_.coordinate(what);
  }
  std::int64_t integer(PlyType, const char* what) {
    find(what);
    return scanner_.integer(what);
  }
  void skip(PlyType) {
    find("a property");
    scanner_.word();
  }
  // Throws if so many values cannot follow: each takes a byte at least.
  void require(std::uint64_t count, PlyType, const char* what) {
    if (count > scanner_.bytes_left()) scanner_.fail_expected(compose("{} {}", count, what));
  }
  bool skip_records(const PlyElement&) { return false; }
  bool take_triangle(const PlyProperty&, std::uint64_t, std::vector<Index>&) { return false; }
  Place place() const { return {"line", scanner_.line()}; }
  [[noreturn]] void fail(std::string_view message) const { scanner_.fail(message); }

 private:
  void find(const char* what) {
    if (!scanner_.find_word()) scanner_.fail_expected(what);
  }

  TextScanner scanner_;
};

class BinaryValues {
 public:
  BinaryValues(std::string_view bytes, std::string_view name, const PlyHeader& header)
      : reader_(bytes, name,
                header.format == PlyFormat::kBigEndian ? ByteOrder::kBig : ByteOrder::kLittle,
                header.bytes) {}

  double coordinate(PlyType type, const char* what) {
    start(type, what);
    return take(type);
  }
  std::int64_t integer(PlyType type, const char* what) {
    const double value = coordinate(type, what);
    const auto whole = static_cast<std::int64_t>(std::abs(value) < 1e15 ? value : 0);
    if (static_cast<double>(whole) != value) fail(compose("{} is not a whole number", what));
    return whole;
  }
  void skip(PlyType type) {
    start(type, "a property");
    reader_.skip(ply_type_bytes(type));
  }
  void require(std::uint64_t count, PlyType type, const char* what) {
    reader_.require(count, ply_type_bytes(type), what);
  }
  // Skips all records of an element at once. Returns false, and skips nothing, if they may differ
  // in length.
  bool skip_records(const PlyElement& element) {
    if (element.has_list()) return false;
    reader_.require(element.count, element.record_bytes(), "record of " + in_quotes(element.name));
    reader_.skip(static_cast<std::size_t>(element.count) * element.record_bytes());
    return true;
  }
  // Takes a list as nearly all are: of three corners, which are below `vertices`, with its length
  // in one byte and each corner in four. Returns false, and takes nothing, if another one follows.
  bool take_triangle(const PlyProperty& list, std::uint64_t vertices, std::vector<Index>& corners) {
    constexpr std::size_t kIndexBytes = 4;
    constexpr std::size_t kBytes = 1 + 3 * kIndexBytes;
    const bool usual = ply_type_bytes(list.count_type) == 1 && is_integer(list.type) &&
                       ply_type_bytes(list.type) == kIndexBytes;
    if (!usual || reader_.bytes_left() < kBytes) return false;
    if (reader_.peek_unsigned<std::uint8_t>(0) != 3) return false;
    // Above this, numbers with a sign are below 0.
    const std::uint64_t end = std::min(vertices, std::uint64_t{1} << 31);
    Triangle t;
    for (std::size_t i = 0; i < 3; ++i) {
      t[i] = reader_.peek_unsigned<std::uint32_t>(1 + i * kIndexBytes);
      if (t[i] >= end) return false;
    }
    corners.assign(t.begin(), t.end());
    value_at_ = reader_.offset() + kBytes - kIndexBytes;
    reader_.skip(kBytes);
    return true;
  }
  // The place of the value that was taken last.
  Place place() const { return {"byte", value_at_}; }
  // Throws with the place of the value that was taken last.
  [[noreturn]] void fail(std::string_view message) const { reader_.fail_at(value_at_, message); }

 private:
  void start(PlyType type, const char* what) {
    value_at_ = reader_.offset();
    if (reader_.bytes_left() < ply_type_bytes(type)) {
      reader_.fail(compose("the file ends where {} is expected", what));
    }
  }
  double take(PlyType type) {
    switch (type) {
      case PlyType::kInt8:
        return reader_.take<std::int8_t, std::uint8_t>();
      case PlyType::kUint8:
        return reader_.take_unsigned<std::uint8_t>();
      case PlyType::kInt16:
        return reader_.take<std::int16_t, std::uint16_t>();
      case PlyType::kUint16:
        return reader_.take_unsigned<std::uint16_t>();
      case PlyType::kInt32:
        return reader_.take<std::int32_t, std::uint32_t>();
      case PlyType::kUint32:
        return reader_.take_unsigned<std::uint32_t>();
      case PlyType::kInt64:
        return static_cast<double>(reader_.take<std::int64_t, std::uint64_t>());
      case PlyType::kUint64:
        return static_cast<double>(reader_.take_unsigned<std::uint64_t>());
      case PlyType::kFloat32:
        return double{reader_.take<float, std::uint32_t>()};
      case PlyType::kFloat64:
        return reader_.take<double, std::uint64_t>();
    }
    return 0;
  }

  ByteReader reader_;
  std::size_t value_at_ = 0;
};

template <typename Values>
class PlyReader {
 public:
  PlyReader(std::string_view bytes, std::string_view name, const PlyHeader& header,
            Warnings& warnings)
      : values_(bytes, name, header), header_(header), names_(bytes, name), warnings_(warnings) {}

  Mesh read() {
    // Faces may stand before the vertices: the header knows how many there will be.
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") vertices_ += element.count;
    }
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") {
        read_vertices(element);
      } else if (element.name == "face" || element.name == "tristrips") {
        read_faces(element, element.name == "tristrips");
      } else {
        skip_element(element);
      }
    }
    return builder_.finish(warnings_);
  }

 private:
  void read_vertices(const PlyElement& element) {
    const std::size_t count = element.properties.size();
    std::vector<int> axis_of(count, -1);
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t i = element.find(kAxisNames[axis]);
      if (i == count || element.properties[i].is_list) {
        names_.fail_at(element.line,
                       compose("element vertex has no number called '{}'", kAxisNames[axis]));
      }
      axis_of[i] = axis;
    }
    // Every coordinate takes a byte at least, so memory is reserved only as far as the file is
    // long.
    values_.require(element.count, PlyType::kUint8, "vertices");
    builder_.reserve_vertices(static_cast<std::size_t>(element.count));
    for (std::uint64_t i = 0; i < element.count; ++i) {
      Vec3 position;
      for (std::size_t j = 0; j < count; ++j) {
        const PlyProperty& property = element.properties[j];
        if (axis_of[j] >= 0) {
          position[axis_of[j]] = values_.coordinate(property.type, "a coordinate");
        } else {
          skip_property(property);
        }
      }
      builder_.add_vertex(position, [&] { return values_.place(); });
    }
  }

  void read_faces(const PlyElement& element, bool strips) {
    const std::size_t list = find_corners(element);
    if (list == element.properties.size()) {
      names_.fail_at(element.line,
                     "element " + in_quotes(element.name) + " has no list called 'vertex_indices'");
    }
    values_.require(element.count, element.properties[list].count_type, "faces");
    if (!strips) builder_.reserve_faces(static_cast<std::size_t>(element.count));
    for (std::uint64_t i = 0; i < element.count; ++i) {
      for (std::size_t j = 0; j < element.properties.size(); ++j) {
        if (j == list) {
          read_corners(element.properties[j], strips);
        } else {
          skip_property(element.properties[j]);
        }
      }
      if (strips) {
        add_strip();
      } else {
        if (corners_.size() < 3) warnings_.skip(Skip::kFewCorners, values_.place());
        builder_.add_face(corners_);
      }
    }
  }

  // Returns the place of the list of corners: the one with a usual name, or else the first list of
  // whole numbers.
  static std::size_t find_corners(const PlyElement& element) {
    const std::vector<PlyProperty>& properties = element.properties;
    for (const char* name : {"vertex_indices", "vertex_index"}) {
      const std::size_t list = element.find(name);
      if (list < properties.size() && properties[list].is_list) return list;
    }
    std::size_t list = 0;
    while (list < properties.size() &&
           !(properties[list].is_list && is_integer(properties[list].type))) {
      ++list;
    }
    return list;
  }

  void read_corners(const PlyProperty& list, bool strips) {
    if (!strips && values_.take_triangle(list, vertices_, corners_)) return;
    const std::int64_t count = read_length(list);
    corners_.clear();
    for (std::int64_t i = 0; i < count; ++i) {
      const std::int64_t index = values_.integer(list.type, "a vertex index");
      if (strips && index == -1) {  // the next strip begins
        corners_.push_back(kNone);
        continue;
      }
      if (index < 0 || static_cast<std::uint64_t>(index) >= vertices_) {
        values_.fail(compose("vertex index {} is out of range, there are {} vertices (from 0)",
                             index, vertices_));
      }
      corners_.push_back(static_cast<Index>(index));
    }
  }

  // Adds the triangles of a strip: each corner makes one with the two corners before it, turned
  // over every other time. Strips repeat a corner to change their direction; that makes no
  // triangle.
  void add_strip() {
    std::size_t start = 0;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (corners_[i] == kNone) {
        start = i + 1;
      } else if (i >= start + 2) {
        Triangle t = {corners_[i - 2], corners_[i - 1], corners_[i]};
        if ((i - start) % 2 == 1) std::swap(t[0], t[1]);
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) builder_.add_face(t.data(), 3);
      }
    }
  }

  std::int64_t read_length(const PlyProperty& list) {
    const std::int64_t count = values_.integer(list.count_type, "the length of a list");
    if (count < 0) values_.fail(compose("a list of length {}", count));
    values_.require(static_cast<std::uint64_t>(count), list.type, "list items");
    return count;
  }

  void skip_property(const PlyProperty& property) {
    const std::int64_t count = property.is_list ? read_length(property) : 1;
    for (std::int64_t i = 0; i < count; ++i) values_.skip(property.type);
  }

  void skip_element(const PlyElement& element) {
    if (element.properties.empty() || values_.skip_records(element)) return;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      for (const PlyProperty& property : element.properties) skip_property(property);
    }
  }

  Values values_;
  const PlyHeader& header_;
  TextScanner names_;  // for messages about the header
  Warnings& warnings_;
  MeshBuilder builder_;
  std::vector<Index> corners_;
  std::uint64_t vertices_ = 0;
};

}  // namespace

Mesh parse_ply(std::string_view bytes, std::string_view name, Warnings& warnings) {
  const PlyHeader header = parse_ply_header(bytes, name);
  if (header.format == PlyFormat::kAscii) {
    return PlyReader<TextValues>(without_padding(bytes), name, header, warnings).read();
  }
  return PlyReader<BinaryValues>(bytes, name, header, warnings).read();
}

std::string format_ply(const Mesh& mesh) {
  std::string out;
  out.reserve(256 + mesh.positions.size() * 12 + mesh.triangles.size() * 13 +
              mesh.quads.size() * 17);
  out += compose(
      "ply\nformat binary_little_endian 1.0\ncomment kdmanifold\n"
      "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      mesh.positions.size(), mesh.triangles.size() + mesh.quads.size());
  for (const Vec3& p : mesh.positions) {
    for (int axis = 0; axis < 3; ++axis) append_f32(out, static_cast<float>(p[axis]));
  }
  for (const Triangle& t : mesh.triangles) {
    append_u8(out, 3);
    for (Index i : t) append_u32(out, i);
  }
  for (const Quad& q : mesh.quads) {
    append_u8(out, 4);
    for (Index i : q) append_u32(out, i);
  }
  return out;
}

}  // namespace kdm
