// SPDX-License-Identifier: MIT
// Reading and writing OBJ.
#include <gtest/gtest.h>

#include "kdmanifold/mesh_io.h"
#include "support/io_fixtures.h"
#include "support/shapes.h"

namespace kdm {
namespace {

using io_test::parse_fault;

Mesh parse_obj(std::string_view text) { return parse_mesh(text, MeshFormat::kObj); }
std::string obj_fault(std::string_view text) { return parse_fault(text, MeshFormat::kObj); }

constexpr const char* kCorners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(ObjRead, AllCornerForms) {
  const Mesh mesh = parse_obj(std::string(kCorners) +
                              "vt 0 0\nvn 0 0 1\n"
                              "f 1 2 3\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\nf 1/1/1 2/1/1 3/1/1\n"
                              "f -4 -3 -2\nf -4/-1 -3/-1/-1 -2//-1\n");
  ASSERT_EQ(mesh.triangles.size(), 6u);
  for (const Triangle& t : mesh.triangles) EXPECT_EQ(t, (Triangle{0, 1, 2}));
  EXPECT_EQ(mesh.source_faces, (std::vector<Index>{0, 1, 2, 3, 4, 5}));
}

TEST(ObjRead, NegativeIndicesCountBackFromTheFace) {
  const Mesh mesh = parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -3 -2 -1\n");
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {1, 2, 3}}));
}

TEST(ObjRead, FacesMayNameVerticesThatFollow) {
  const Mesh mesh = parse_obj(std::string("f 1 2 3 4\n") + kCorners);
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(mesh.source_faces, (std::vector<Index>{0, 0}));
}

TEST(ObjRead, LineEndsCommentsAndContinuations) {
  const Mesh mesh = parse_obj(
      "\xef\xbb\xbf# a comment that ends in a backslash \\\r\n"
      "\r\nv 0 0 \\\r\n 0\r\n  v\t+1.0 0e0 .0 # behind\nv 1. 1E+0 -0\rv 0 1 0\n"
      "f 1 2 \\\n3\\\n 4");
  ASSERT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.positions[1], Vec3(1, 0, 0));
  EXPECT_EQ(mesh.positions[2], Vec3(1, 1, 0));
  EXPECT_EQ(mesh.triangles.size(), 2u);
}

TEST(ObjRead, OtherStatementsAreIgnored) {
  const Mesh mesh = parse_obj(
      "mtllib C:\\models\\\no object\ng group one\ns off\nusemtl red\nvp 0.1\nvt 0 0\nvn 0 0 1\n"
      "v 0 0 0 0.5 0.5 0.5\nv 1 0 0 1.0\nv 0 1 0\np 1\nl 1 2\ncurv 0 1 1 2\nunknown ? !\nf 1 2 "
      "3\n");
  EXPECT_EQ(mesh.positions.size(), 3u);
  EXPECT_EQ(mesh.triangles.size(), 1u);
}

TEST(ObjRead, NothingIsAnEmptyMesh) {
  EXPECT_TRUE(parse_obj("").triangles.empty());
  EXPECT_TRUE(parse_obj("# nothing\n\n").positions.empty());
  EXPECT_EQ(parse_obj("v 1 2 3").positions.size(), 1u);
}

TEST(ObjRead, ConcavePolygonsKeepTheirArea) {
  // An L of three unit squares, and a square with a corner in the middle of one edge.
  const Mesh mesh = parse_obj(
      "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\nf 4 5 6 1 2 3\n");
  EXPECT_EQ(mesh.triangles.size(), 8u);
  EXPECT_DOUBLE_EQ(describe(mesh).area, 6);
  EXPECT_EQ(mesh.source_faces, (std::vector<Index>{0, 0, 0, 0, 1, 1, 1, 1}));
}

TEST(ObjRead, NumbersArePrecise) {
  const Mesh mesh = parse_obj("v 0.1 1e-300 123456789.123456789\nv 1e-400 -0.0 3\n");
  EXPECT_EQ(mesh.positions[0], Vec3(0.1, 1e-300, 123456789.123456789));
  EXPECT_EQ(mesh.positions[1], Vec3(0, 0, 3));
}

TEST(ObjRead, FaultsNameTheLine) {
  const std::string v = kCorners;  // four lines
  EXPECT_EQ(obj_fault(v + "f 1 2 0\n"),
            "in: line 5: vertex index 0 is out of range, OBJ counts from 1");
  EXPECT_EQ(obj_fault(v + "f 1 2 5\n"),
            "in: line 5: vertex index 5 is out of range, there are 4 vertices");
  EXPECT_EQ(obj_fault(v + "\nf 1 2 -5\n"),
            "in: line 6: vertex index -5 is out of range, there are 4 vertices before it");
  EXPECT_EQ(obj_fault(v + "f 1 2 9\nf 1 2 3\nf 1 2 7\n"),
            "in: line 5: vertex index 9 is out of range, there are 4 vertices");
  EXPECT_EQ(obj_fault(v + "f 1 2 99999999999999999999\n"),
            "in: line 5: a vertex index is expected, not '99999999999999999999'");
  EXPECT_EQ(obj_fault(v + "f 1 2 4294967296\n"),
            "in: line 5: vertex index 4294967296 is out of range, there are 4 vertices");
  EXPECT_EQ(obj_fault(v + "f 1 2\n"),
            "in: line 5: no face is left: 1 face has fewer than three corners");
  EXPECT_EQ(obj_fault(v + "f\n"),
            "in: line 5: no face is left: 1 face has fewer than three corners");
  EXPECT_EQ(obj_fault(v + "f 1 2 three\n"), "in: line 5: a vertex index is expected, not 'three'");
  EXPECT_EQ(obj_fault(v + "f 1/x 2 3\n"),
            "in: line 5: a texture or normal index is expected, not 'x'");
  EXPECT_EQ(obj_fault(v + "f 1/1/1/1 2 3\n"),
            "in: line 5: the end of a corner is expected, not '/1'");
  EXPECT_EQ(obj_fault("v 1 2\nv 1 2 3\n"),
            "in: line 1: the line ends where coordinate z is expected");
  EXPECT_EQ(obj_fault("\r\nv 1 2"), "in: line 2: the file ends where coordinate z is expected");
  EXPECT_EQ(obj_fault("v 1 2 x\n"), "in: line 1: coordinate z is expected, not 'x'");
  EXPECT_EQ(obj_fault("v 1.5.5 2 3\n"), "in: line 1: coordinate x is expected, not '1.5.5'");
  EXPECT_EQ(obj_fault("v +-1 2 3\n"), "in: line 1: coordinate x is expected, not '+-1'");
  EXPECT_EQ(obj_fault(std::string_view("v 0 0 0\n\0\1\2 x\n", 15)),
            "in: line 2: a keyword is expected, not '\?\?\?'");
}

TEST(ObjRead, LongNonsenseIsQuotedShort) {
  const std::string message = obj_fault("v " + std::string(1000, 'x') + " 0 0\n");
  EXPECT_LT(message.size(), 100u);
  EXPECT_NE(message.find("xxx...'"), std::string::npos) << message;
}

TEST(ObjRead, EveryBeginningAndEveryChangedByte) {
  const std::string text =
      "# c\r\no x\nv 0 0 0\nv 1.5 0 -1e-3\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n"
      "f 1/1/1 2//1 \\\n 3/1 -1\nf 1 2 3\n";
  EXPECT_GT(io_test::refused_beginnings(text, MeshFormat::kObj), 20u);
  io_test::try_changed_bytes(text, MeshFormat::kObj);
}

TEST(ObjWrite, Text) {
  EXPECT_EQ(format_mesh(io_test::pyramid(), MeshFormat::kObj),
            "v 0 0 0\nv 1 0 0\nv 1 1.5 0\nv 0 1.5 0\nv 0.25 0.1 -1e-07\n"
            "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\nf 4 3 2 1\n");
}

// What a program sees that reads 64 bits is what one sees that reads 32.
TEST(ObjWrite, ExactDigitsReadBackTheSameInBothPrecisions) {
  Mesh mesh = shapes::rotated(shapes::cube(), Vec3(1, 2, 3), 0.7);
  for (Vec3& p : mesh.positions) p = p.cast<float>().cast<double>();
  for (const MeshFormat format : {MeshFormat::kObj, MeshFormat::kOff}) {
    EXPECT_EQ(parse_mesh(format_mesh(mesh, format, Digits::kExact), format).positions,
              mesh.positions);
    const Mesh rounded = parse_mesh(format_mesh(mesh, format), format);
    EXPECT_NE(rounded.positions, mesh.positions);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      EXPECT_EQ(rounded.positions[i].cast<float>(), mesh.positions[i].cast<float>());
    }
  }
}

}  // namespace
}  // namespace kdm
