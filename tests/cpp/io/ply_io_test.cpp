// SPDX-License-Identifier: MIT
// Reading and writing PLY.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "kdmanifold/mesh_io.h"
#include "support/io_fixtures.h"

namespace kdm {
namespace {

using io_test::parse_fault;

Mesh parse_ply(std::string_view bytes) { return parse_mesh(bytes, MeshFormat::kPly); }
std::string ply_fault(std::string_view bytes) { return parse_fault(bytes, MeshFormat::kPly); }

const std::string kVertexHeader =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kFaceHeader = "element face 1\nproperty list uchar int vertex_indices\n";

std::string ascii(const std::string& header, const std::string& body) {
  return "ply\nformat ascii 1.0\n" + header + "end_header\n" + body;
}

// Puts bytes of a number together in either order.
class Bytes {
 public:
  explicit Bytes(bool big) : big_(big) {}
  template <typename Number>
  Bytes& add(Number number) {
    char bytes[sizeof(Number)];
    std::memcpy(bytes, &number, sizeof bytes);  // the tests run on little-endian machines
    if (big_) std::reverse(bytes, bytes + sizeof bytes);
    text_.append(bytes, sizeof bytes);
    return *this;
  }
  const std::string& text() const { return text_; }

 private:
  bool big_;
  std::string text_;
};

TEST(PlyRead, Ascii) {
  const Mesh mesh =
      parse_ply(ascii("comment made by hand\nobj_info x\n" + kVertexHeader + kFaceHeader,
                      "0 0 0\n1 0 0\n1 1 0\n0 1 0.5\n4 0 1 2 3\n"));
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.positions[3], Vec3(0, 1, 0.5));
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.source_faces, (std::vector<Index>{0, 0}));
}

TEST(PlyRead, AsciiWithCrLfAndOneValueALine) {
  EXPECT_EQ(parse_ply("ply\r\nformat ascii 1.0\r\nelement vertex 3\r\nproperty float x\r\nproperty "
                      "float y\r\nproperty float z\r\nelement face 1\r\nproperty list uchar int "
                      "vertex_index\r\nend_header\r\n0\r\n0\r\n0\r\n1 0 0 0 1\r\n0 3 0\r\n1 2\r\n")
                .triangles,
            (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(PlyRead, OtherElementsAndPropertiesAreSkipped) {
  const std::string header =
      "element material 2\nproperty int ambient\nproperty list uchar float weights\n"
      "element nothing 1000000000000\n"
      "element vertex 3\nproperty uchar red\nproperty double z\nproperty list int int more\n"
      "property short x\nproperty float y\n"
      "element edge 1\nproperty int a\n"
      "element face 1\nproperty float quality\nproperty list uint ushort vertex_indices\n"
      "property list uchar float texcoord\n";
  const Mesh mesh = parse_ply(ascii(header,
                                    "5 2 0.5 0.5\n6 0\n255 3 0 1 2\n0 0 2 8 9 4 5\n1 0.5 1 7 0 1\n"
                                    "77\n0.5 3 0 1 2 2 0.1 0.2\n"));
  EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{1, 2, 3}, {4, 5, 0}, {0, 1, 0.5}}));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(PlyRead, BinaryInBothByteOrdersWithAllTypes) {
  for (const bool big : {false, true}) {
    const std::string header =
        std::string("ply\nformat binary_") + (big ? "big" : "little") +
        "_endian 1.0\nelement extra 2\nproperty int8 a\nproperty list uint16 float64 b\n"
        "element plain 2\nproperty uint16 a\n"
        "element vertex 3\nproperty float32 x\nproperty double y\nproperty int16 z\n"
        "property uint8 c\nelement face 2\nproperty list int32 uint32 vertex_indices\n"
        "property list uint8 int8 flags\nend_header\n";
    Bytes body(big);
    body.add<std::int8_t>(-1).add<std::uint16_t>(2).add(1.0).add(2.0);
    body.add<std::int8_t>(-1).add<std::uint16_t>(0);
    body.add<std::uint16_t>(7).add<std::uint16_t>(8);
    for (int i = 0; i < 3; ++i) {
      body.add(0.5f * static_cast<float>(i * i))
          .add(0.1 * i)
          .add<std::int16_t>(static_cast<std::int16_t>(-300 * i));
      body.add<std::uint8_t>(200);
    }
    for (int face = 0; face < 2; ++face) {
      body.add<std::int32_t>(3).add<std::uint32_t>(2).add<std::uint32_t>(1).add<std::uint32_t>(0);
      body.add<std::uint8_t>(1).add<std::int8_t>(-5);
    }
    const Mesh mesh = parse_ply(header + body.text());
    ASSERT_EQ(mesh.positions.size(), 3u);
    EXPECT_EQ(mesh.positions[2], Vec3(2, 0.2, -600));
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{2, 1, 0}, {2, 1, 0}}));
    const std::string bytes = header + body.text();
    EXPECT_EQ(io_test::refused_beginnings(bytes, MeshFormat::kPly), bytes.size());
    if (!big) io_test::try_changed_bytes(bytes, MeshFormat::kPly);
  }
}

// A binary file of four vertices, with faces of these numbers of corners: 0, 1, 2 and so on, but
// for the last corner of all.
std::string binary_faces(bool big, const std::string& type, const std::vector<int>& faces,
                         std::int32_t last_corner) {
  Bytes body(big);
  for (int i = 0; i < 4; ++i) {
    body.add(i == 1 || i == 2 ? 1.f : 0.f).add(i >= 2 ? 1.f : 0.f).add(0.f);
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    body.add<std::uint8_t>(static_cast<std::uint8_t>(faces[i]));
    for (int corner = 0; corner < faces[i]; ++corner) {
      const bool last = i + 1 == faces.size() && corner + 1 == faces[i];
      body.add<std::int32_t>(last ? last_corner : corner);
    }
    body.add<std::uint8_t>(7);
  }
  return std::string("ply\nformat binary_") + (big ? "big" : "little") + "_endian 1.0\n" +
         kVertexHeader + "element face " + std::to_string(faces.size()) + "\nproperty list uchar " +
         type + " vertex_indices\nproperty uchar flags\nend_header\n" + body.text();
}

TEST(PlyRead, BinaryTrianglesAmongOtherFaces) {
  for (const bool big : {false, true}) {
    for (const char* type : {"int", "uint"}) {
      const std::string bytes = binary_faces(big, type, {3, 4, 2, 3, 3}, 3);
      const Mesh mesh = parse_ply(bytes);
      EXPECT_EQ(mesh.triangles,
                (std::vector<Triangle>{{0, 1, 2}, {0, 1, 2}, {0, 2, 3}, {0, 1, 2}, {0, 1, 3}}));
      EXPECT_EQ(mesh.source_faces, (std::vector<Index>{0, 1, 1, 3, 4}));
      EXPECT_EQ(io_test::refused_beginnings(bytes, MeshFormat::kPly), bytes.size());
      // The last corner begins five bytes before the end.
      const std::string at = "byte " + std::to_string(bytes.size() - 5) + ": vertex index ";
      EXPECT_NE(ply_fault(binary_faces(big, type, {3, 3}, 4))
                    .find(": vertex index 4 is out of range, there are 4 vertices (from 0)"),
                std::string::npos);
      const std::string negative = ply_fault(binary_faces(big, type, {3, 4, 2, 3, 3}, -1));
      EXPECT_NE(negative.find(at + (type[0] == 'u' ? "4294967295" : "-1") + " is out of range"),
                std::string::npos)
          << negative;
    }
  }
}

TEST(PlyRead, NamesAndTypesInUse) {
  const std::string body = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const char* list : {"list uchar int vertex_index", "list uchar uint indices",
                           "list uint8 int64 VERTEX_INDICES", "LIST UCHAR UINT64 Vertex_Index"}) {
    const Mesh mesh =
        parse_ply(ascii("Element Vertex 3\nPROPERTY Float X\nproperty float Y\nproperty "
                        "float Z\nelement face 1\nproperty " +
                            std::string(list) + "\n",
                        body));
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}})) << list;
  }
  for (const bool big : {false, true}) {
    Bytes data(big);
    for (const float c : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) data.add(c);
    data.add<std::uint8_t>(3).add<std::int64_t>(2).add<std::int64_t>(0).add<std::int64_t>(1);
    const Mesh mesh =
        parse_ply(std::string("ply\nformat binary_") + (big ? "big" : "little") +
                  "_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                  "property float z\nelement face 1\nproperty list uchar int64 "
                  "vertex_indices\nend_header\n" +
                  data.text());
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{2, 0, 1}}));
  }
}

TEST(PlyRead, FacesBeforeVertices) {
  const Mesh mesh =
      parse_ply(ascii(kFaceHeader + kVertexHeader, "4 0 1 2 3\n0 0 0\n1 0 0\n0.2 0.2 0\n0 1 0\n"));
  // Concave at the third corner, which was not known yet.
  EXPECT_NEAR(describe(mesh).area, 0.2, 1e-12);
}

TEST(PlyRead, TriangleStrips) {
  const Mesh mesh =
      parse_ply(ascii(kVertexHeader + "element tristrips 1\nproperty list int int vertex_indices\n",
                      "0 0 0\n1 0 0\n1 1 0\n0 1 0\n10 0 1 2 3 -1 3 2 2 1 0\n"));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}, {2, 1, 0}}));
}

TEST(PlyRead, PointsOnly) {
  const Mesh mesh = parse_ply(ascii(kVertexHeader, "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"));
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_TRUE(mesh.triangles.empty());
}

TEST(PlyRead, HeaderFaultsNameTheLine) {
  EXPECT_EQ(ply_fault(""), "in: line 1: the file ends where the keyword 'ply' is expected");
  EXPECT_EQ(ply_fault("plyy\n"), "in: line 1: the keyword 'ply' is expected, not 'plyy'");
  EXPECT_EQ(ply_fault("ply\nformat binary 1.0\n"),
            "in: line 2: 'ascii', 'binary_little_endian' or 'binary_big_endian' is expected, not "
            "'binary'");
  EXPECT_EQ(ply_fault("ply\nformat ascii 1.0\nproperty float x\n"),
            "in: line 3: a property before the first element");
  EXPECT_EQ(ply_fault("ply\nformat ascii 1.0\nelement vertex -3\n"),
            "in: line 3: the number of elements is -3, below 0");
  EXPECT_EQ(ply_fault("ply\nformat ascii 1.0\nelement vertex 3\nproperty half x\n"),
            "in: line 4: a type such as 'float' or 'int' is expected, not 'half'");
  EXPECT_EQ(ply_fault("ply\nformat ascii 1.0\nelement f 1\nproperty list float int v\n"),
            "in: line 4: a list cannot be counted in a floating-point type");
  EXPECT_EQ(ply_fault("ply\nformat ascii 1.0\nwhatever\n"),
            "in: line 3: 'element', 'property' or 'end_header' is expected, not 'whatever'");
  EXPECT_EQ(ply_fault("ply\nformat ascii 1.0\n"),
            "in: line 3: the file ends where 'element', 'property' or 'end_header' is expected");
  EXPECT_EQ(ply_fault("ply\nend_header\n"), "in: line 2: the header has no 'format' line");
  EXPECT_EQ(ply_fault(ascii("element vertex 1\nproperty float x\nproperty float y\n", "0 0\n")),
            "in: line 3: element vertex has no number called 'z'");
  EXPECT_EQ(ply_fault(ascii("element face 1\nproperty list uchar float corners\n", "3 0 0 0\n")),
            "in: line 3: element 'face' has no list called 'vertex_indices'");
}

TEST(PlyRead, BodyFaultsNameTheLineOrByte) {
  const std::string header = kVertexHeader + kFaceHeader;  // data begin in line 10
  const std::string vertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  EXPECT_EQ(ply_fault(ascii(header, "0 0 0\n1 0 0\n")),
            "in: line 12: the file ends where a coordinate is expected");
  EXPECT_EQ(ply_fault(ascii(header, "0 0 x\n")), "in: line 10: a coordinate is expected, not 'x'");
  EXPECT_EQ(ply_fault(ascii(header, vertices + "3 0 1 4\n")),
            "in: line 14: vertex index 4 is out of range, there are 4 vertices (from 0)");
  EXPECT_EQ(ply_fault(ascii(header, vertices + "-3 0 1 2\n")), "in: line 14: a list of length -3");
  EXPECT_EQ(ply_fault(ascii(header, vertices + "999999999999 0 1 2\n")),
            "in: line 14: 999999999999 list items is expected, not '0'");

  std::string bytes = format_mesh(io_test::pyramid(), MeshFormat::kPly);
  const std::size_t data = bytes.find("end_header\n") + 11;
  std::string at = std::to_string(data + 60 + 1);
  bytes[data + 60 + 1] = 5;  // the first corner
  EXPECT_EQ(ply_fault(bytes),
            "in: byte " + at + ": vertex index 5 is out of range, there are 5 vertices (from 0)");
  bytes = format_mesh(io_test::pyramid(), MeshFormat::kPly);
  std::memcpy(bytes.data() + data + 8, "\0\0\x80\x7f", 4);
  at = std::to_string(data + 8);
  std::vector<Warning> warnings;
  EXPECT_EQ(parse_mesh(bytes, MeshFormat::kPly, "in", &warnings).triangles.size(), 2u);
  EXPECT_EQ(warnings, (std::vector<Warning>{{"FACES_SKIPPED",
                                             "3 faces have a coordinate that is not a number; "
                                             "skipped; the first is at byte " +
                                                 at}}));
}

TEST(PlyRead, CountsThatNothingBacksAreNotAllocated) {
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    for (const char* element :
         {"element vertex 999999999999999999\nproperty uchar x\nproperty uchar y\nproperty uchar "
          "z\n",
          "element face 999999999999999999\nproperty list uchar int vertex_indices\n",
          "element other 999999999999999999\nproperty double x\n",
          "element other 999999999999999999\nproperty list uint double x\n"}) {
      ply_fault(std::string("ply\nformat ") + format + " 1.0\n" + element + "end_header\n0 0 0\n");
    }
  }
}

TEST(PlyRead, EveryBeginningAndEveryChangedByte) {
  const std::string binary = format_mesh(io_test::pyramid(), MeshFormat::kPly);
  EXPECT_EQ(io_test::refused_beginnings(binary, MeshFormat::kPly), binary.size());
  io_test::try_changed_bytes(binary, MeshFormat::kPly);
  const std::string text =
      ascii(kVertexHeader + kFaceHeader, "0 0 0\n1 0 0\n1 1 0\n0 1 0.5\n4 0 1 2 3\n");
  // Without its last line end the file is still whole.
  EXPECT_EQ(io_test::refused_beginnings(text, MeshFormat::kPly), text.size() - 1);
  io_test::try_changed_bytes(text, MeshFormat::kPly);
}

TEST(PlyWrite, HeaderAndSize) {
  const std::string bytes = format_mesh(io_test::pyramid(), MeshFormat::kPly);
  const std::string header =
      "ply\nformat binary_little_endian 1.0\ncomment kdmanifold\nelement vertex 5\n"
      "property float x\nproperty float y\nproperty float z\nelement face 5\n"
      "property list uchar int vertex_indices\nend_header\n";
  EXPECT_EQ(bytes.substr(0, header.size()), header);
  EXPECT_EQ(bytes.size(), header.size() + 5 * 12 + 4 * 13 + 17);
}

}  // namespace
}  // namespace kdm
