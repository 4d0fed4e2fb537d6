// SPDX-License-Identifier: MIT
// STL: binary (80 bytes of anything, a count, 50 bytes a facet) and ASCII. Facets share no vertices
// in this format, and none are joined here.
#include <algorithm>
#include <cmath>

#include "geometry/triangle.h"
#include "io/bytes.h"
#include "io/formats.h"
#include "io/mesh_builder.h"
#include "io/text_scanner.h"
#include "text/compose.h"

namespace kdm {
namespace {

constexpr std::size_t kHeaderBytes = 84;
constexpr std::size_t kFacetBytes = 50;
constexpr std::string_view kAxisNames = "xyz";

bool same_word(std::string_view word, std::string_view lower_case) {
  return word.size() == lower_case.size() &&
         std::equal(word.begin(), word.end(), lower_case.begin(), [](char a, char b) {
           return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
         });
}

// Tells whether a file is ASCII. Binary files may begin with "solid" too; so a file that is as long
// as its count of facets asks for is binary, and so is one whose beginning is no text.
bool is_ascii(std::string_view bytes, std::string_view name) {
  if (bytes.size() >= kHeaderBytes) {
    ByteReader reader(bytes, name, ByteOrder::kLittle, kHeaderBytes - 4);
    const std::uint64_t count = reader.take_unsigned<std::uint32_t>();
    if (bytes.size() == kHeaderBytes + kFacetBytes * count) return false;
  }
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && same_word(bytes.substr(first, 5), "solid") &&
         bytes.substr(0, 1024).find('\0') == std::string_view::npos;
}

Mesh parse_binary(std::string_view bytes, std::string_view name) {
  ByteReader reader(bytes, name, ByteOrder::kLittle, 0);
  reader.require(1, kHeaderBytes, "STL header");
  reader.skip(kHeaderBytes - 4);
  const std::uint32_t count = reader.take_unsigned<std::uint32_t>();
  reader.require(count, kFacetBytes, "STL facet");
  MeshBuilder builder;
  builder.reserve_vertices(std::size_t{count} * 3);
  builder.reserve_faces(count);
  for (std::uint32_t facet = 0; facet < count; ++facet) {
    reader.skip(12);  // the normal: often zero, and wrong where it matters
    const Index first = builder.vertex_count();
    for (int corner = 0; corner < 3; ++corner) {
      Vec3 position;
      for (int axis = 0; axis < 3; ++axis) {
        const float value = reader.take<float, std::uint32_t>();
        if (!std::isfinite(value)) {
          reader.fail_at(reader.offset() - 4,
                         compose("coordinate {} of facet {} is not a finite number",
                                 kAxisNames[static_cast<std::size_t>(axis)], facet));
        }
        position[axis] = double{value};
      }
      builder.add_vertex(position);
    }
    const Index corners[3] = {first, first + 1, first + 2};
    builder.add_face(corners, 3);
    reader.skip(2);
  }
  return builder.finish();
}

class AsciiStlReader {
 public:
  AsciiStlReader(std::string_view text, std::string_view name) : scanner_(text, name) {}

  Mesh read() {
    while (scanner_.find_word()) read_solid();
    return builder_.finish();
  }

 private:
  void read_solid() {
    expect("solid");
    scanner_.skip_line();  // its name
    while (true) {
      scanner_.find_word();
      if (next_is("endsolid")) break;
      read_facet();
    }
    scanner_.skip_line();
  }

  void read_facet() {
    expect("facet");
    expect("normal");
    // Some writers put "nan" here. The normal follows from the order of the corners anyway.
    for (int i = 0; i < 3; ++i) scanner_.word();
    expect("outer");
    expect("loop");
    corners_.clear();
    while (true) {
      scanner_.find_word();
      if (next_is("endloop")) break;
      expect("vertex");
      const double x = scanner_.number("coordinate x");
      const double y = scanner_.number("coordinate y");
      const double z = scanner_.number("coordinate z");
      corners_.push_back(builder_.vertex_count());
      builder_.add_vertex({x, y, z});
    }
    if (corners_.size() < 3) {
      scanner_.fail(compose("a facet needs three vertices, this one has {}", corners_.size()));
    }
    builder_.add_face(corners_);
    expect("endfacet");
  }

  void expect(const char* keyword) {
    scanner_.find_word();
    if (!next_is(keyword)) scanner_.fail_expected(compose("'{}'", keyword));
  }

  bool next_is(std::string_view keyword) {
    TextScanner ahead = scanner_;
    if (!same_word(ahead.word(), keyword)) return false;
    scanner_ = ahead;
    return true;
  }

  TextScanner scanner_;
  MeshBuilder builder_;
  std::vector<Index> corners_;
};

// Appends a facet. Its normal is computed from the rounded positions that the file holds, so that
// the same bytes come out for positions of 32 and of 64 bits.
void append_facet(std::string& out, const Mesh& mesh, const Triangle& t) {
  Vec3 corners[3];
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i] = mesh.positions[t[i]].cast<float>().cast<double>();
  }
  Vec3 normal = doubled_area_vector(corners[0], corners[1], corners[2]);
  const double length =
      std::sqrt(normal.x() * normal.x() + normal.y() * normal.y() + normal.z() * normal.z());
  // In this format, a normal of zero asks the reader to compute it.
  if (length > 0) normal /= length;
  for (const Vec3& v : {normal, corners[0], corners[1], corners[2]}) {
    for (int axis = 0; axis < 3; ++axis) append_f32(out, static_cast<float>(v[axis]));
  }
  append_u16(out, 0);
}

}  // namespace

Mesh parse_stl(std::string_view bytes, std::string_view name) {
  return is_ascii(bytes, name) ? AsciiStlReader(bytes, name).read() : parse_binary(bytes, name);
}

std::string format_stl(const Mesh& mesh) {
  const std::size_t count = mesh.triangles.size() + 2 * mesh.quads.size();
  std::string out = "kdmanifold";  // a header that begins with "solid" would pass for ASCII
  out.reserve(kHeaderBytes + kFacetBytes * count);
  out.resize(kHeaderBytes - 4, ' ');
  append_u32(out, static_cast<std::uint32_t>(count));
  for (const Triangle& t : mesh.triangles) append_facet(out, mesh, t);
  for (const Quad& q : mesh.quads) {
    append_facet(out, mesh, {q[0], q[1], q[2]});
    append_facet(out, mesh, {q[0], q[2], q[3]});
  }
  return out;
}

}  // namespace kdm
