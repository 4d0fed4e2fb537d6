// SPDX-License-Identifier: MIT
// Wavefront OBJ. Reads `v` and `f` statements and passes over everything else; writes `vn` as well.

#include <algorithm>
#include <vector>

#include "io/decode_text.h"
#include "io/formats.h"
#include "io/mesh_builder.h"
#include "io/text_line.h"
#include "io/text_scanner.h"
#include "kdmanifold/error.h"
#include "mesh/sort.h"
#include "text/compose.h"

namespace kdm {
namespace {

class ObjReader {
 public:
  ObjReader(std::string_view text, std::string_view name)
      : scanner_(text, name, {.comments = true, .continuations = true}) {}

  Mesh read(Warnings& warnings) {
    while (scanner_.find_word()) {
      const std::string_view keyword = scanner_.word();
      const char letter = keyword.size() == 1 ? keyword[0] : '\0';
      if (letter == 'v' || letter == 'V') {
        read_vertex();
      } else if (letter == 'f' || letter == 'F' || keyword == "fo") {
        read_face(warnings);
      } else if (static_cast<unsigned char>(keyword[0]) < ' ') {
        // Any word may be a keyword of some extension, but this is no text.
        scanner_.fail("a keyword is expected, not " + in_quotes(keyword));
      }
      // Colours behind coordinates and statements without geometry end here.
      scanner_.skip_line();
    }
    if (highest_ >= std::int64_t{builder_.vertex_count()}) fail_range(highest_line_, highest_ + 1);
    return builder_.finish(warnings);
  }

 private:
  void read_vertex() {
    const double x = scanner_.coordinate("coordinate x");
    const double y = scanner_.coordinate("coordinate y");
    const double z = scanner_.coordinate("coordinate z");
    builder_.add_vertex({x, y, z}, [&] { return Place{"line", scanner_.line()}; });
  }

  void read_face(Warnings& warnings) {
    corners_.clear();
    const std::size_t line = scanner_.line();
    while (!scanner_.at_line_end()) corners_.push_back(read_corner());
    if (corners_.size() < 3) warnings.skip(Skip::kFewCorners, {"line", line});
    builder_.add_face(corners_);
  }

  // Reads v, v/vt, v//vn or v/vt/vn. The vertex may be defined later in the file.
  Index read_corner() {
    const std::int64_t number = scanner_.integer_prefix("a vertex index");
    for (int part = 0; part < 2 && scanner_.peek() == '/'; ++part) {
      scanner_.skip_char();
      if (scanner_.peek() != '/' && scanner_.peek() != '\0') {
        scanner_.integer_prefix("a texture or normal index");
      }
    }
    if (scanner_.peek() != '\0') scanner_.fail_expected("the end of a corner");
    if (number == 0) scanner_.fail("vertex index 0 is out of range, OBJ counts from 1");
    const std::int64_t count = builder_.vertex_count();
    const std::int64_t index = number < 0 ? count + number : number - 1;
    if (index < 0 || index >= kNone) fail_range(scanner_.line(), number);
    if (index >= count && index > highest_) {
      highest_ = index;
      highest_line_ = scanner_.line();
    }
    return static_cast<Index>(index);
  }

  [[noreturn]] void fail_range(std::size_t line, std::int64_t number) const {
    scanner_.fail_at(line,
                     compose("vertex index {} is out of range, there are {} vertices{}", number,
                             builder_.vertex_count(), number < 0 ? " before it" : ""));
  }

  TextScanner scanner_;
  MeshBuilder builder_;
  std::vector<Index> corners_;
  // The highest vertex that a face named before it was defined, if any.
  std::int64_t highest_ = -1;
  std::size_t highest_line_ = 0;
};

}  // namespace

Mesh parse_obj(std::string_view text, std::string_view name, Warnings& warnings) {
  return ObjReader(without_padding(text), name).read(warnings);
}

namespace {

// Numbers the normals of corners, so that corners with equal normals share one `vn` statement.
class Normals {
 public:
  explicit Normals(const std::vector<std::array<float, 3>>& corners) : distinct_(corners) {
    // -0 becomes 0: they are equal, so the sort would keep either of them.
    for (std::array<float, 3>& normal : distinct_) {
      for (float& value : normal) value += 0.0f;
    }
    sort_up(distinct_);
    distinct_.erase(std::unique(distinct_.begin(), distinct_.end()), distinct_.end());
  }
  const std::vector<std::array<float, 3>>& distinct() const { return distinct_; }
  std::uint64_t number(const std::array<float, 3>& normal) const {
    const auto found = std::lower_bound(distinct_.begin(), distinct_.end(), normal);
    return static_cast<std::uint64_t>(found - distinct_.begin()) + 1;
  }

 private:
  std::vector<std::array<float, 3>> distinct_;
};

}  // namespace

std::string format_obj(const Mesh& mesh, Digits digits) {
  std::string text;
  text.reserve(mesh.positions.size() * 36 + mesh.triangles.size() * 24 + mesh.quads.size() * 32 +
               mesh.corner_normals.size() * 16);
  for (const Vec3& p : mesh.positions) {
    TextLine line("v");
    line.add(p, digits);
    line.append_to(text);
  }
  const Normals normals(mesh.corner_normals);
  for (const std::array<float, 3>& n : normals.distinct()) {
    TextLine line("vn");
    for (const float coordinate : n) line.add(coordinate);
    line.append_to(text);
  }
  std::size_t corner = 0;
  const auto write_face = [&](const auto& face) {
    TextLine line("f");
    for (const Index vertex : face) {
      // In 64 bits, for the last vertex's number is one more than its index.
      const std::uint64_t number = std::uint64_t{vertex} + 1;
      if (mesh.corner_normals.empty()) {
        line.add(number);
      } else {
        line.add(number, "//", normals.number(mesh.corner_normals[corner++]));
      }
    }
    line.append_to(text);
  };
  for (const Triangle& t : mesh.triangles) write_face(t);
  for (const Quad& q : mesh.quads) write_face(q);
  return text;
}

}  // namespace kdm
