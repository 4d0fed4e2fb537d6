// SPDX-License-Identifier: MIT
// Reading and writing OFF.
#include <gtest/gtest.h>

#include "kdmanifold/mesh_io.h"
#include "support/io_fixtures.h"

namespace kdm {
namespace {

using io_test::parse_fault;

Mesh parse_off(std::string_view text) { return parse_mesh(text, MeshFormat::kOff); }
std::string off_fault(std::string_view text) { return parse_fault(text, MeshFormat::kOff); }

TEST(OffRead, HeadersInUse) {
  const std::string body = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const char* header :
       {"OFF\n3 1 0\n", "OFF 3 1 0\n", "OFF3 1 0\n", "OFF\n3 1\n",
        "# first\nOFF # kind\n\n3 1 3\n\n", "3 1 0\n", "OFF\r\n3 1 0\r\n",
        "\xef\xbb\xbfOFF\n3\n1 0\n", "off\n3 1 0\n", "OFF\n3\n1\n3\n", "Off 3\n1\n3\n"}) {
    const Mesh mesh = parse_off(header + body);
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}})) << header;
    EXPECT_EQ(mesh.positions[1], Vec3(1, 0, 0)) << header;
  }
}

TEST(OffRead, ColoursAndNormalsAreIgnored) {
  EXPECT_EQ(
      parse_off("COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0 0 0 0\n0 1 0 1 1 1 1\n3 0 1 2 9 9 9\n")
          .triangles.size(),
      1u);
  EXPECT_EQ(parse_off("NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n").positions[2],
            Vec3(0, 1, 0));
  EXPECT_EQ(parse_off("STCNOFF\n1 0 0\n4 5 6 0 0 1 1 1 1 1 0 0\n").positions[0], Vec3(4, 5, 6));
}

TEST(OffRead, WhiteSpaceIsFree) {
  for (const char* text :
       {"OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2", "OFF\n3 1 0\n0 0 0 1 0 0\n0 1 0 3 0 1 2\n",
        "OFF\n3 1 0\n0\n0\n0\n1 0\n0 0\n1 0\n3\n0 1\n2\n",
        "NOFF 3 1 0 0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1 3 0 1 2",
        "coff\n3 1 0\n0 0 0 1 1 1 1\n1 0 0 1 1 1 1\n0 1 0 1 1 1 1\n3 0 1 2 1 1 1 1\n"}) {
    const Mesh mesh = parse_off(text);
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}})) << text;
    EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})) << text;
  }
}

TEST(OffRead, PolygonsSegmentsAndPoints) {
  const Mesh mesh = parse_off(
      "OFF\n6 4 0\n0 0 0\n2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n1 0\n2 0 1\n6 0 1 2 3 4 5\n3 0 1 2\n");
  EXPECT_EQ(mesh.triangles.size(), 5u);
  EXPECT_DOUBLE_EQ(describe(mesh).area, 3 + 1);
  EXPECT_EQ(mesh.source_faces, (std::vector<Index>{2, 2, 2, 2, 3}));
}

TEST(OffRead, FaultsNameTheLine) {
  const std::string start = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(off_fault(""), "in: line 1: the file ends where the keyword 'OFF' is expected");
  EXPECT_EQ(off_fault("solid\n"), "in: line 1: the keyword 'OFF' is expected, not 'solid'");
  EXPECT_EQ(off_fault("4OFF\n"), "in: line 1: only three coordinates a vertex are supported");
  EXPECT_EQ(off_fault("OFF BINARY\n"),
            "in: line 1: binary OFF is not supported, use the text form");
  EXPECT_EQ(off_fault("OFF\n3 -1 0\n"), "in: line 2: the number of faces is -1, below 0");
  EXPECT_EQ(off_fault("OFF\n3\n"),
            "in: line 3: the file ends where the number of faces is expected");
  EXPECT_EQ(off_fault("OFF\n3 1 0\n0 0 0\n1 0 0\n"),
            "in: line 5: the file ends where vertex 3 of 3 is expected");
  EXPECT_EQ(off_fault("OFF\n3 1 0\n0 0\n1 0 0\n"),
            "in: line 5: the file ends where coordinate z is expected");
  EXPECT_EQ(off_fault(start), "in: line 6: the file ends where face 1 of 1 is expected");
  EXPECT_EQ(off_fault(start + "3 0 1 3\n"),
            "in: line 6: vertex index 3 is out of range, there are 3 vertices (from 0)");
  EXPECT_EQ(off_fault(start + "3 0 1 -1\n"),
            "in: line 6: vertex index -1 is out of range, there are 3 vertices (from 0)");
  EXPECT_EQ(off_fault(start + "3 0 1\n"),
            "in: line 7: the file ends where a vertex index is expected");
  EXPECT_EQ(off_fault(start + "-3 0 1 2\n"), "in: line 6: a face with -3 corners");
  EXPECT_EQ(off_fault(start + "999999999999 0 1 2\n"),
            "in: line 7: the file ends where a vertex index is expected");
  // Counts that nothing backs must not be allocated.
  EXPECT_EQ(off_fault("OFF\n999999999999999999 999999999999999999 0\n0 0 0\n"),
            "in: line 4: the file ends where vertex 2 of 999999999999999999 is expected");
}

TEST(OffRead, EveryBeginningAndEveryChangedByte) {
  const std::string text = format_mesh(io_test::pyramid(), MeshFormat::kOff);
  EXPECT_GE(io_test::refused_beginnings(text, MeshFormat::kOff), text.size() - 1);
  io_test::try_changed_bytes(text, MeshFormat::kOff);
  io_test::try_changed_bytes("COFF # c\n3 1 0\n0 0 0 1 1\r\n1 0 0\n0 1 0\n3 0 1 2 # c",
                             MeshFormat::kOff);
}

TEST(OffWrite, Text) {
  EXPECT_EQ(format_mesh(io_test::pyramid(), MeshFormat::kOff),
            "OFF\n5 5 0\n0 0 0\n1 0 0\n1 1.5 0\n0 1.5 0\n0.25 0.1 -1e-07\n"
            "3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n4 3 2 1 0\n");
}

}  // namespace
}  // namespace kdm
