// SPDX-License-Identifier: MIT
// OFF (Geomview's object file format), in text only. Passes over colours, normals and texture
// coordinates of the COFF, NOFF and STOFF variants.

#include <algorithm>
#include <optional>
#include <vector>

#include "io/decode_text.h"
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
  OffReader(std::string_view text, std::string_view name, Warnings& warnings)
      : scanner_(text, name, {.comments = true}), warnings_(warnings) {}

  Mesh read() {
    scanner_.find_word();
    read_keyword();
    const std::uint64_t vertices = read_count("the number of vertices");
    const std::size_t line = scanner_.line();
    const std::uint64_t faces = read_count("the number of faces");
    skip_edge_count(scanner_.line() != line);
    // Memory is reserved only as far as the file is long: a vertex takes six bytes at least
    // ("0 0 0\n"), a face two ("0\n").
    const std::uint64_t bytes = scanner_.bytes_left();
    builder_.reserve_vertices(static_cast<std::size_t>(std::min(vertices, bytes / 6 + 1)));
    builder_.reserve_faces(static_cast<std::size_t>(std::min(faces, bytes / 2 + 1)));
    records_left_ = vertices + faces;
    end_record(0, scanner_.line());
    for (std::uint64_t i = 0; i < vertices; ++i) read_vertex(i, vertices);
    for (std::uint64_t i = 0; i < faces; ++i) read_face(i, faces);
    return builder_.finish(warnings_);
  }

 private:
  // Takes a word that is in upper or lower case.
  bool take(std::string_view upper, std::string_view lower) {
    return scanner_.take(upper) || scanner_.take(lower);
  }

  // Reads [ST][C][N][4][n]OFF. In some files the counts follow without a blank, and in some the
  // keyword is missing.
  void read_keyword() {
    const char first = scanner_.peek();
    if (first >= '0' && first <= '9' && first != '4') return;
    const TextScanner start = scanner_;
    if (take("ST", "st")) extra_numbers_ += 2;
    if (take("C", "c")) extra_numbers_ += 4;
    if (take("N", "n")) extra_numbers_ += 3;
    const bool four = scanner_.take("4");
    const bool any_dimension = scanner_.take("n");
    if (!take("OFF", "off") && !scanner_.take("Off")) {
      scanner_ = start;
      if (four) return;
      scanner_.fail_expected("the keyword 'OFF'");
    }
    if (four || any_dimension) scanner_.fail("only three coordinates a vertex are supported");
    TextScanner ahead = scanner_;
    const std::string_view word = ahead.word();
    if (word == "BINARY" || word == "binary") {
      scanner_.fail("binary OFF is not supported, use the text form");
    }
  }

  // The number of edges, which nobody needs, may be missing; if the counts have a line each, so has
  // this one.
  void skip_edge_count(bool line_each) {
    if (!scanner_.at_line_end()) {
      scanner_.word();
      return;
    }
    TextScanner ahead = scanner_;
    if (!ahead.find_word()) return;
    ahead.word();
    if (line_each && ahead.at_line_end()) scanner_ = ahead;
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
    const std::size_t line = scanner_.line();
    const double x = scanner_.coordinate("coordinate x");
    const double y = read_coordinate("coordinate y");
    const double z = read_coordinate("coordinate z");
    builder_.add_vertex({x, y, z}, [&] { return place(); });
    --records_left_;
    end_record(extra_numbers_, line);
  }

  void read_face(std::uint64_t number, std::uint64_t count) {
    if (!scanner_.find_word()) {
      scanner_.fail_expected(compose("face {} of {}", number + 1, count));
    }
    const std::size_t line = scanner_.line();
    const std::int64_t corners = scanner_.integer("the number of corners");
    if (corners < 0) scanner_.fail(compose("a face with {} corners", corners));
    corners_.clear();
    for (std::int64_t i = 0; i < corners; ++i) {
      scanner_.find_word();
      const std::int64_t index = scanner_.integer("a vertex index");
      if (index < 0 || index >= std::int64_t{builder_.vertex_count()}) {
        scanner_.fail(compose("vertex index {} is out of range, there are {} vertices (from 0)",
                              index, builder_.vertex_count()));
      }
      corners_.push_back(static_cast<Index>(index));
    }
    if (corners_.size() < 3) warnings_.skip(Skip::kFewCorners, {"line", line});
    builder_.add_face(corners_);
    --records_left_;
    end_record(0, line);
  }

  double read_coordinate(const char* what) {
    scanner_.find_word();
    return scanner_.coordinate(what);
  }

  // Passes over what belongs to a record behind its numbers: the rest of the line (colours and the
  // like), unless records and lines have nothing to do with each other. Then it is the numbers that
  // the keyword tells.
  void end_record(int extra_numbers, std::size_t first_line) {
    if (scanner_.at_line_end()) return;
    if (!is_free_) is_free_ = scanner_.line() != first_line || !has_line_each();
    if (!*is_free_) {
      scanner_.skip_line();
    } else {
      for (int i = 0; i < extra_numbers && scanner_.find_word(); ++i) scanner_.word();
    }
  }

  // Tells whether at least as many lines follow as records.
  bool has_line_each() const {
    TextScanner ahead = scanner_;
    ahead.skip_line();
    std::uint64_t lines = 0;
    for (; lines < records_left_ && ahead.find_word(); ++lines) ahead.skip_line();
    return lines == records_left_;
  }

  Place place() const { return {"line", scanner_.line()}; }

  TextScanner scanner_;
  Warnings& warnings_;
  MeshBuilder builder_;
  std::vector<Index> corners_;
  int extra_numbers_ = 0;  // of each vertex, behind its coordinates
  std::uint64_t records_left_ = 0;
  std::optional<bool> is_free_;  // whether records share or span lines; known once it matters
};

}  // namespace

Mesh parse_off(std::string_view text, std::string_view name, Warnings& warnings) {
  return OffReader(without_padding(text), name, warnings).read();
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
