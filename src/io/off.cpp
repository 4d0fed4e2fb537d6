// SPDX-License-Identifier: MIT
// OFF (Geomview's object file format), in text only. Passes over colours, normals and texture
// coordinates of the COFF, NOFF and STOFF variants.

#include <algorithm>

#include "io/formats.h"
#include "io/mesh_builder.h"
#include "io/text_line.h"
#include "io/text_scanner.h"
#include "kdmanifold/error.h"
#include "text/compose.h"

namespace kdm {
namespace {

class OffReader {
 public:
  OffReader(std::string_view text, std::string_view name)
      : scanner_(text, name, {.comments = true}) {
    scanner_.take("\xef\xbb\xbf");
  }

  Mesh read() {
    scanner_.find_word();
    read_keyword();
    const std::uint64_t vertices = read_count("the number of vertices");
    const std::uint64_t faces = read_count("the number of faces");
    scanner_.skip_line();  // the number of edges, which nobody needs
    // Memory is reserved only as far as the file is long: a vertex takes six bytes at least
    // ("0 0 0\n"), a face two ("0\n").
    const std::uint64_t bytes = scanner_.bytes_left();
    builder_.reserve_vertices(static_cast<std::size_t>(std::min(vertices, bytes / 6 + 1)));
    builder_.reserve_faces(static_cast<std::size_t>(std::min(faces, bytes / 2 + 1)));
    for (std::uint64_t i = 0; i < vertices; ++i) read_vertex(i, vertices);
    for (std::uint64_t i = 0; i < faces; ++i) read_face(i, faces);
    return builder_.finish();
  }

 private:
  // Reads [ST][C][N][4][n]OFF. In some files the counts follow without a blank, and in some the
  // keyword is missing.
  void read_keyword() {
    const char first = scanner_.peek();
    if (first >= '0' && first <= '9' && first != '4') return;
    const TextScanner start = scanner_;
    scanner_.take("ST");
    scanner_.take("C");
    scanner_.take("N");
    const bool four = scanner_.take("4");
    const bool any_dimension = scanner_.take("n");
    if (!scanner_.take("OFF")) {
      scanner_ = start;
      if (four) return;
      scanner_.fail_expected("the keyword 'OFF'");
    }
    if (four || any_dimension) scanner_.fail("only three coordinates a vertex are supported");
    TextScanner ahead = scanner_;
    if (ahead.word() == "BINARY") scanner_.fail("binary OFF is not supported, use the text form");
  }

  std::uint64_t read_count(const char* what) {
    scanner_.find_word();
    const std::int64_t count = scanner_.integer(what);
    if (count < 0) scanner_.fail(compose("{} is {}, below 0", what, count));
    return static_cast<std::uint64_t>(count);
  }

  void read_vertex(std::uint64_t number, std::uint64_t count) {
    if (!scanner_.find_word()) {
      scanner_.fail_expected(compose("vertex {} of {}", number + 1, count));
    }
    const double x = scanner_.number("coordinate x");
    const double y = scanner_.number("coordinate y");
    const double z = scanner_.number("coordinate z");
    builder_.add_vertex({x, y, z});
    scanner_.skip_line();
  }

  void read_face(std::uint64_t number, std::uint64_t count) {
    if (!scanner_.find_word()) {
      scanner_.fail_expected(compose("face {} of {}", number + 1, count));
    }
    const std::int64_t corners = scanner_.integer("the number of corners");
    if (corners < 0) scanner_.fail(compose("a face with {} corners", corners));
    corners_.clear();
    for (std::int64_t i = 0; i < corners; ++i) {
      const std::int64_t index = scanner_.integer("a vertex index");
      if (index < 0 || index >= std::int64_t{builder_.vertex_count()}) {
        scanner_.fail(compose("vertex index {} is out of range, there are {} vertices (from 0)",
                              index, builder_.vertex_count()));
      }
      corners_.push_back(static_cast<Index>(index));
    }
    builder_.add_face(corners_);
    scanner_.skip_line();  // a colour may follow
  }

  TextScanner scanner_;
  MeshBuilder builder_;
  std::vector<Index> corners_;
};

}  // namespace

Mesh parse_off(std::string_view text, std::string_view name) {
  return OffReader(text, name).read();
}

std::string format_off(const Mesh& mesh, Digits digits) {
  std::string text;
  text.reserve(mesh.positions.size() * 34 + mesh.triangles.size() * 24 + mesh.quads.size() * 32);
  text +=
      compose("OFF\n{} {} 0\n", mesh.positions.size(), mesh.triangles.size() + mesh.quads.size());
  for (const Vec3& p : mesh.positions) {
    TextLine line;
    line.add(p, digits);
    line.append_to(text);
  }
  const auto write_face = [&](std::string_view corners, const auto& face) {
    TextLine line(corners);
    for (const Index vertex : face) line.add(vertex);
    line.append_to(text);
  };
  for (const Triangle& t : mesh.triangles) write_face("3", t);
  for (const Quad& q : mesh.quads) write_face("4", q);
  return text;
}

}  // namespace kdm
