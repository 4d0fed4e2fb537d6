// SPDX-License-Identifier: MIT
// STL: binary (80 bytes of anything, a count, 50 bytes a facet) and ASCII. Facets share no vertices
// in this format, and none are joined here.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include "geometry/triangle.h"
#include "io/bytes.h"
#include "io/decode_text.h"
#include "io/formats.h"
#include "io/mesh_builder.h"
#include "io/sniff.h"
#include "io/text_scanner.h"
#include "text/compose.h"

namespace kdm {
namespace {

constexpr std::size_t kHeaderBytes = 84;
constexpr std::size_t kFacetBytes = 50;

bool same_word(std::string_view word, std::string_view lower_case) {
  return word.size() == lower_case.size() &&
         std::equal(word.begin(), word.end(), lower_case.begin(), [](char a, char b) {
           return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
         });
}

// Adds a facet that is skipped: it gets a number.
void skip_facet(MeshBuilder& builder, Skip why, Place place, Warnings& warnings) {
  warnings.skip(why, place);
  builder.add_face(nullptr, 0);
}

// Tells whether a file is ASCII. Binary files may begin with "solid" too; so a file that is as long
// as its count of facets asks for is binary, and so is one whose beginning is no text.
bool is_ascii(std::string_view bytes) {
  const std::string_view text = without_padding(bytes);
  return !text.empty() && !is_whole_binary_stl(bytes) && looks_like_text(text);
}

// Returns how many facets a binary file has. Some programs write no count, or a wrong one: if whole
// facets fill the file, its length is right.
std::uint64_t count_facets(ByteReader& reader, Warnings& warnings) {
  const std::uint64_t count = reader.take_unsigned<std::uint32_t>();
  const std::uint64_t room = reader.bytes_left() / kFacetBytes;
  const bool filled = room > 0 && reader.bytes_left() % kFacetBytes == 0;
  const bool no_count = count == 0 || count == 0xffffffffu;
  if (count == room || room == 0 || !(filled || no_count)) return count;
  warnings.add("FACETS_MISCOUNTED",
               compose("the header counts {} facets, but the file is as long as {}; these are read",
                       count, room));
  return room;
}

Mesh parse_binary(std::string_view bytes, std::string_view name, Warnings& warnings) {
  ByteReader reader(bytes, name, ByteOrder::kLittle, 0);
  reader.require(1, kHeaderBytes, "STL header");
  reader.skip(kHeaderBytes - 4);
  const std::uint64_t count = count_facets(reader, warnings);
  reader.require(count, kFacetBytes, "STL facet");
  MeshBuilder builder;
  builder.reserve_vertices(static_cast<std::size_t>(count) * 3);
  builder.reserve_faces(static_cast<std::size_t>(count));
  for (std::uint64_t facet = 0; facet < count; ++facet) {
    const Place place{"byte", reader.offset()};
    reader.skip(12);  // the normal: often zero, and wrong where it matters
    Vec3 positions[3];
    bool finite = true;
    for (Vec3& position : positions) {
      for (int axis = 0; axis < 3; ++axis) {
        position[axis] = double{reader.take<float, std::uint32_t>()};
      }
      finite = finite && MeshBuilder::is_somewhere(position);
    }
    reader.skip(2);
    if (!finite) {
      skip_facet(builder, Skip::kNotFinite, place, warnings);
      continue;
    }
    const Index first = builder.vertex_count();
    for (const Vec3& position : positions) builder.add_vertex(position);
    const Index corners[3] = {first, first + 1, first + 2};
    builder.add_face(corners, 3);
  }
  return builder.finish(warnings);
}

// Reads what is written, which is not always what the format asks for: solids without a name or an
// end, "end loop" for "endloop", lines of colours and of whatever else between the facets.
class AsciiStlReader {
 public:
  AsciiStlReader(std::string_view text, std::string_view name, Warnings& warnings)
      : scanner_(text, name), warnings_(warnings) {}

  Mesh read() {
    std::optional<TextScanner> unknown;  // the first statement that is none
    bool facets = false;
    bool open = false;
    while (scanner_.find_word()) {
      if (next_is("facet")) {
        read_facet();
        facets = true;
      } else if (next_is("solid")) {
        skip_name();
        open = true;
      } else if (next_is_end_of("solid")) {
        skip_name();
        open = false;
      } else {
        if (!unknown) unknown = scanner_;
        scanner_.skip_line();
      }
    }
    if (!facets && unknown) unknown->fail_expected("'facet'");
    if (!facets && open) scanner_.fail_expected("'facet'");
    return builder_.finish(warnings_);
  }

 private:
  // A name ends with its line, or where a facet begins: some files are a single line.
  void skip_name() {
    while (!scanner_.at_line_end() && !at_facet()) scanner_.word();
  }

  bool at_facet() const {
    TextScanner ahead = scanner_;
    return same_word(ahead.word(), "facet") && same_word(ahead.word(), "normal");
  }

  void read_facet() {
    const Place place{"line", scanner_.line()};
    // Some writers put "nan" here. The normal follows from the order of the corners anyway.
    if (next_is("normal")) {
      for (int i = 0; i < 3; ++i) scanner_.word();
    }
    skip_lines_before("outer");
    expect("outer");
    expect("loop");
    positions_.clear();
    while (true) {
      scanner_.find_word();
      if (next_is("vertex")) {
        const double x = scanner_.coordinate("coordinate x");
        const double y = scanner_.coordinate("coordinate y");
        const double z = scanner_.coordinate("coordinate z");
        positions_.push_back({x, y, z});
      } else if (next_is_end_of("loop")) {
        break;
      } else {
        scanner_.fail_expected("'vertex'");
      }
    }
    scanner_.find_word();
    // The next facet ends this one as well.
    if (!next_is_end_of("facet") && !at_facet()) scanner_.fail_expected("'endfacet'");
    add_facet(place);
  }

  void add_facet(Place place) {
    if (!std::all_of(positions_.begin(), positions_.end(), MeshBuilder::is_somewhere)) {
      return skip_facet(builder_, Skip::kNotFinite, place, warnings_);
    }
    if (positions_.size() < 3) return skip_facet(builder_, Skip::kFewCorners, place, warnings_);
    corners_.resize(positions_.size());
    std::iota(corners_.begin(), corners_.end(), builder_.vertex_count());
    for (const Vec3& position : positions_) builder_.add_vertex(position);
    builder_.add_face(corners_);
  }

  // Passes over lines of colours inside a facet.
  void skip_lines_before(std::string_view keyword) {
    while (scanner_.find_word()) {
      TextScanner ahead = scanner_;
      const std::string_view word = ahead.word();
      if (same_word(word, keyword)) return;
      if (!same_word(word, "color") && !same_word(word, "colour")) return;
      scanner_.skip_line();
    }
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

  // Takes "endloop" or "end loop" for "loop".
  bool next_is_end_of(std::string_view keyword) {
    TextScanner ahead = scanner_;
    std::string_view word = ahead.word();
    if (!same_word(word.substr(0, 3), "end")) return false;
    word.remove_prefix(3);
    if (word.empty()) word = ahead.word();
    if (!same_word(word, keyword)) return false;
    scanner_ = ahead;
    return true;
  }

  TextScanner scanner_;
  Warnings& warnings_;
  MeshBuilder builder_;
  std::vector<Vec3> positions_;
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

Mesh parse_stl(std::string_view bytes, std::string_view name, Warnings& warnings) {
  if (is_ascii(bytes)) return AsciiStlReader(without_padding(bytes), name, warnings).read();
  return parse_binary(bytes, name, warnings);
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
