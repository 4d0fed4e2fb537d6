// SPDX-License-Identifier: MIT
// Reading and writing STL.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "kdmanifold/mesh_io.h"
#include "support/io_fixtures.h"

namespace kdm {
namespace {

using io_test::parse_fault;

Mesh parse_stl(std::string_view bytes) { return parse_mesh(bytes, MeshFormat::kStl); }
std::string stl_fault(std::string_view bytes) { return parse_fault(bytes, MeshFormat::kStl); }

std::string binary() { return format_mesh(io_test::pyramid(), MeshFormat::kStl); }

const char* const kAscii =
    "solid a name\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n"
    "   vertex 0 1.5 0\n  endloop\n endfacet\n"
    " FACET NORMAL nan nan nan\n  OUTER LOOP\n   VERTEX 0 0 0\n   VERTEX 1 0 0\n"
    "   VERTEX 0 0 -2e-1\n  ENDLOOP\n ENDFACET\nendsolid a name\n";

TEST(StlRead, Binary) {
  const std::string bytes = binary();
  EXPECT_EQ(bytes.size(), 84u + 6 * 50u);
  const Mesh mesh = parse_stl(bytes);
  ASSERT_EQ(mesh.triangles.size(), 6u);
  EXPECT_EQ(mesh.positions.size(), 18u);
  EXPECT_EQ(mesh.source_faces, (std::vector<Index>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(mesh.positions[mesh.triangles[1][1]], Vec3(1, 1.5, 0));
  EXPECT_EQ(mesh.positions[mesh.triangles[0][2]].z(), double{-1e-7f});
}

TEST(StlRead, BinaryThatBeginsWithSolid) {
  std::string bytes = binary();
  std::memcpy(bytes.data(), "solid", 5);
  EXPECT_EQ(parse_stl(bytes).triangles.size(), 6u);
  // With bytes behind the last facet, too: the count is no text.
  EXPECT_EQ(parse_stl(bytes + "appendix").triangles.size(), 6u);
}

TEST(StlRead, Ascii) {
  const Mesh mesh = parse_stl(kAscii);
  ASSERT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.positions.size(), 6u);
  EXPECT_EQ(mesh.positions[5], Vec3(0, 0, -0.2));
  EXPECT_EQ(mesh.triangles[1], (Triangle{3, 4, 5}));
  // Several solids in one file, and one without facets.
  EXPECT_EQ(parse_stl(std::string(kAscii) + "\n" + kAscii).triangles.size(), 4u);
  EXPECT_TRUE(parse_stl("solid\nendsolid\n").triangles.empty());
}

TEST(StlRead, BinaryWithAWrongCount) {
  for (const char* count : {"\0\0\0\0", "\xff\xff\xff\xff", "\1\0\0\0", "\x20\0\0\0"}) {
    std::string bytes = binary();
    std::memcpy(bytes.data() + 80, count, 4);
    std::vector<Warning> warnings;
    EXPECT_EQ(parse_mesh(bytes, MeshFormat::kStl, "in", &warnings).triangles.size(), 6u);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0].code, "FACETS_MISCOUNTED");
    EXPECT_NE(warnings[0].message.find("the file is as long as 6; these are read"),
              std::string::npos);
  }
  std::string bytes = binary() + "tail";
  std::memcpy(bytes.data() + 80, "\0\0\0\0", 4);
  EXPECT_EQ(parse_stl(bytes).triangles.size(), 6u);
}

TEST(StlRead, AsciiAsItIsWritten) {
  const std::string loop = "outer loop vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n";
  const std::string facet = "facet normal 0 0 1\n" + loop + "endloop\nendfacet\n";
  for (const std::string& text :
       {"solid x\nfacet normal 0 0 1\n" + loop + "end loop\nend facet\nend solid\n",
        "solid x\n" + facet,                                    // no end
        "solid x " + facet + "endsolid x\n",                    // a facet behind the name
        "solid x\ncolor 0.2 0.3 0.4\n" + facet + "whatever\n",  // lines that STL does not know
        "solid x\nfacet normal 0 0 1\ncolor 1 0 0\n" + loop + "endloop\nendfacet\nendsolid\n",
        "SOLID X\n" + facet + std::string("endsolid\n\0\0\x1a\n", 13), facet,
        "\xef\xbb\xbfsolid x\n" + facet + "endsolid x\n"}) {
    EXPECT_EQ(parse_stl(text).triangles.size(), 1u) << text;
  }
  EXPECT_EQ(parse_stl("solid x " + facet + "endsolid x solid y " + facet).triangles.size(), 2u);
  const std::string no_end = "facet normal 0 0 1\n" + loop + "endloop\n";
  EXPECT_EQ(parse_stl("solid\n" + no_end + no_end + facet + "endsolid\n").triangles.size(), 3u);
}

TEST(StlRead, FaultsNameTheLineOrByte) {
  EXPECT_EQ(stl_fault(""),
            "in: byte 0: 1 x STL header of 84 bytes should follow, but the file ends at "
            "byte 0");
  EXPECT_EQ(stl_fault(binary().substr(0, 300)),
            "in: byte 84: 6 x STL facet of 50 bytes should follow, but the file ends at byte 300");
  std::string bytes = binary();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(bytes.data() + 84 + 50 + 12 + 16, &nan, 4);
  std::vector<Warning> warnings;
  const Mesh rest = parse_mesh(bytes, MeshFormat::kStl, "in", &warnings);
  EXPECT_EQ(rest.source_faces, (std::vector<Index>{0, 2, 3, 4, 5}));
  EXPECT_EQ(rest.positions.size(), 15u);
  EXPECT_EQ(warnings, (std::vector<Warning>{{"FACES_SKIPPED",
                                             "1 face has a coordinate that is not a number; "
                                             "skipped; it is at byte 134"}}));
  // A count that nothing backs must not be allocated.
  bytes = binary() + "tail";
  std::memcpy(bytes.data() + 80, "\xff\xff\xff\x7f", 4);
  EXPECT_EQ(stl_fault(bytes),
            "in: byte 84: 2147483647 x STL facet of 50 bytes should follow, but the "
            "file ends at byte 388");
  EXPECT_EQ(stl_fault("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n"),
            "in: line 4: the line ends where coordinate z is expected");
  EXPECT_EQ(stl_fault("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 inf\n"),
            "in: line 5: the file ends where 'vertex' is expected");
  EXPECT_EQ(stl_fault("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 1\nendloop\nendfacet"),
            "in: line 2: no face is left: 1 face has fewer than three corners");
  EXPECT_EQ(stl_fault("solid x\nface\n"), "in: line 2: 'facet' is expected, not 'face'");
  EXPECT_EQ(stl_fault("solid x\n"), "in: line 2: the file ends where 'facet' is expected");
}

TEST(StlRead, EveryBeginningAndEveryChangedByte) {
  const std::string bytes = binary();
  // Whole facets are read, with a warning.
  EXPECT_EQ(io_test::refused_beginnings(bytes, MeshFormat::kStl), bytes.size() - 5);
  const Mesh small = {io_test::pyramid().positions, {{0, 1, 4}}, {}, {}, {}};
  io_test::try_changed_bytes(format_mesh(small, MeshFormat::kStl), MeshFormat::kStl);
  // Only between its facets may the file be cut short without a complaint.
  const std::string text = kAscii;
  EXPECT_EQ(io_test::refused_beginnings(text, MeshFormat::kStl), text.size() - 24);
  io_test::try_changed_bytes(text, MeshFormat::kStl);
}

TEST(StlWrite, NormalsHeaderAndQuads) {
  const std::string bytes = binary();
  EXPECT_EQ(bytes.substr(0, 10), "kdmanifold");
  EXPECT_EQ(bytes.substr(80, 4), std::string("\x06\0\0\0", 4));
  float normal[3];
  std::memcpy(normal, bytes.data() + 84 + 4 * 50, sizeof normal);  // the base: both facets down
  EXPECT_EQ(normal[0], 0);
  EXPECT_EQ(normal[1], 0);
  EXPECT_EQ(normal[2], -1);
  const Mesh flat = {{{1, 1, 1}, {2, 2, 2}, {3, 3, 3}}, {{0, 1, 2}}, {}, {}, {}};
  const std::string zero = format_mesh(flat, MeshFormat::kStl);
  EXPECT_EQ(zero.substr(84, 12), std::string(12, '\0'));
}

// Positions come as doubles natively and as floats from JavaScript: the same file must come out.
TEST(StlWrite, DependsOnFloatsOnly) {
  Mesh exact = io_test::pyramid();
  for (Vec3& p : exact.positions) p += Vec3(0.1, 0.7, 0.3);
  Mesh rounded = exact;
  for (Vec3& p : rounded.positions) {
    for (int axis = 0; axis < 3; ++axis) {
      volatile const float value = static_cast<float>(p[axis]);
      p[axis] = double{value};
    }
  }
  EXPECT_EQ(format_mesh(exact, MeshFormat::kStl), format_mesh(rounded, MeshFormat::kStl));
}

}  // namespace
}  // namespace kdm
