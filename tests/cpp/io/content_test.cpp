// SPDX-License-Identifier: MIT
// What content is, whatever its name says; how its text is encoded; and what is skipped.
#include <gtest/gtest.h>

#include "io/decode_text.h"
#include "io/sniff.h"
#include "kdmanifold/mesh_io.h"
#include "support/io_fixtures.h"

namespace kdm {
namespace {

using io_test::parse_fault;

constexpr MeshFormat kContentFormats[] = {MeshFormat::kObj, MeshFormat::kStl, MeshFormat::kPly,
                                          MeshFormat::kOff};

std::string utf16(std::string_view ascii, bool big) {
  std::string text;
  for (const char c : ascii) text += big ? std::string({'\0', c}) : std::string({c, '\0'});
  return text;
}

std::vector<Warning> warnings_of(std::string_view bytes, MeshFormat format) {
  std::vector<Warning> warnings;
  parse_mesh(bytes, format, "in", &warnings);
  return warnings;
}

TEST(Content, CountsMoreThanTheFormatAskedFor) {
  const Mesh pyramid = io_test::pyramid();
  for (const MeshFormat is : kContentFormats) {
    for (const MeshFormat asked : kContentFormats) {
      EXPECT_EQ(parse_mesh(format_mesh(pyramid, is), asked).triangles.size(), 6u);
    }
  }
  const char* const stl =
      "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
      "endloop\nendfacet\nendsolid\n";
  EXPECT_EQ(parse_mesh(stl, MeshFormat::kObj).triangles.size(), 1u);
  EXPECT_EQ(parse_mesh("# by hand\nmtllib a.mtl\no x\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
                       MeshFormat::kStl)
                .triangles.size(),
            1u);
}

TEST(Content, OtherFilesAreNamed) {
  const struct {
    std::string bytes;
    const char* message;
  } files[] = {
      {"\x1f\x8b\x08 and more", "gzip-compressed; unpack it first"},
      {"PK\x03\x04 and more", "a zip archive; unpack it first"},
      {"PK\x03\x04 ... 3D/3dmodel.model", "a 3MF file (a zip archive)"},
      {"glTF\x02", "binary glTF (GLB), not the format that its name says"},
      {"{\"asset\": {}}", "glTF in JSON (.gltf); .glb files are read"},
      {" \n<!DOCTYPE HTML><p>", "a web page (HTML)"},
      {"\xef\xbb\xbf<?xml version='1.0'?><COLLADA>", "a COLLADA file"},
      {"Kaydara FBX Binary  ", "an FBX file"},
      {"ISO-10303-21;\nHEADER;", "a STEP file"},
      {std::string("MM\x20\0\0\0\x02\0\x0a\0\0\0\x03\0\0\0", 16) + std::string(16, 'x'),
       "a 3DS file"},
      {"  0\nSECTION\n", "a DXF file"},
      {"version https://git-lfs.github.com/spec/v1\n",
       "a Git LFS pointer, not the file that it stands for"},
  };
  for (const auto& [bytes, message] : files) {
    for (const MeshFormat asked : kContentFormats) {
      EXPECT_EQ(parse_fault(bytes, asked), std::string("in: byte 0: the file is ") + message);
    }
  }
}

TEST(Content, Utf16InBothOrdersWithAndWithoutAMark) {
  for (const MeshFormat format : {MeshFormat::kObj, MeshFormat::kOff}) {
    const std::string text = format_mesh(io_test::pyramid(), format);
    for (const bool big : {false, true}) {
      const std::string mark = big ? "\xfe\xff" : "\xff\xfe";
      EXPECT_EQ(parse_mesh(mark + utf16(text, big), format).triangles.size(), 6u);
      EXPECT_EQ(parse_mesh(utf16(text, big), format).triangles.size(), 6u);
    }
  }
  EXPECT_EQ(utf8_from_utf16(std::string_view("\xff\xfe\xe9\0\xac\x20\x3d\xd8\x00\xde\x00\xdc!", 13),
                            ByteOrder::kLittle),
            "\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80\xef\xbf\xbd");
}

TEST(Content, MarksAndPaddingAroundText) {
  const std::string padding("\0\x1a\0\0", 4);
  for (const MeshFormat format : {MeshFormat::kObj, MeshFormat::kOff}) {
    const std::string text = format_mesh(io_test::pyramid(), format);
    EXPECT_EQ(parse_mesh("\xef\xbb\xbf" + text + padding, format).triangles.size(), 6u);
  }
  const std::string ply =
      "\xef\xbb\xbfply\nformat ascii 1.0\nelement vertex 3\nproperty float X\nproperty float Y\n"
      "property float Z\nelement face 1\nproperty list uchar int indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n3 0 1 2";
  EXPECT_EQ(parse_mesh(ply + padding, MeshFormat::kPly).triangles.size(), 1u);
}

TEST(Skipped, FacesWithACoordinateThatIsNotANumber) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 nan 0\nv 1.#QNAN 1e999 -inf\n";
  std::vector<Warning> warnings;
  const Mesh mesh = parse_mesh(vertices + "f 1 2 5\nf 1 2 3\nf 1 2 3 4\nf 2 3 5\n",
                               MeshFormat::kObj, "in", &warnings);
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(mesh.source_faces, (std::vector<Index>{1}));
  EXPECT_EQ(mesh.positions[4], mesh.positions[0]);
  EXPECT_EQ(warnings, (std::vector<Warning>{{"FACES_SKIPPED",
                                             "3 faces have a coordinate that is not a number; "
                                             "skipped; the first is at line 4"}}));
  // Nobody minds a vertex that no face uses.
  EXPECT_TRUE(warnings_of(vertices + "f 1 2 3\n", MeshFormat::kObj).empty());
  EXPECT_EQ(parse_fault(vertices + "f 1 2 4\n", MeshFormat::kObj),
            "in: line 4: no face is left: 1 face has a coordinate that is not a number");
}

TEST(Skipped, FacesWithFewCorners) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_EQ(
      warnings_of(vertices + "f 1 2\nf 1 2 3\n", MeshFormat::kObj),
      (std::vector<Warning>{
          {"FACES_SKIPPED", "1 face has fewer than three corners; skipped; it is at line 4"}}));
  EXPECT_EQ(warnings_of("OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n2 0 1\n1 0\n", MeshFormat::kOff),
            (std::vector<Warning>{
                {"FACES_SKIPPED",
                 "2 faces have fewer than three corners; skipped; the first is at line 7"}}));
}

TEST(DecimalCommas, AreNamed) {
  EXPECT_EQ(
      parse_fault("v -0,5 1 2\n", MeshFormat::kObj),
      "in: line 1: coordinate x is '-0,5', with a decimal comma; a decimal point is expected");
  EXPECT_EQ(parse_fault("v 1,5,5 1 2\n", MeshFormat::kObj),
            "in: line 1: coordinate x is expected, not '1,5,5'");
}

}  // namespace
}  // namespace kdm
