// SPDX-License-Identifier: MIT
// Knows formats by their first bytes or words.
#include "io/sniff.h"

#include <algorithm>
#include <cmath>

#include "io/bytes.h"
#include "io/decode_text.h"
#include "io/text_scanner.h"
#include "kdmanifold/error.h"
#include "text/lower_case.h"

namespace kdm {
namespace {

// Nothing needs more to be known; longer comments or names leave it open.
constexpr std::size_t kSample = 65536;

struct Beginning {
  std::string_view bytes;
  std::string_view what;
};

constexpr Beginning kBinary[] = {
    {"\x1f\x8b", "gzip-compressed; unpack it first"},
    {"BZh", "bzip2-compressed; unpack it first"},
    {std::string_view("\xfd\x37zXZ\0", 6), "xz-compressed; unpack it first"},
    {"\x28\xb5\x2f\xfd", "zstd-compressed; unpack it first"},
    {"7z\xbc\xaf\x27\x1c", "a 7z archive; unpack it first"},
    {"Rar!\x1a\x07", "a RAR archive; unpack it first"},
    {"glTF", "binary glTF (GLB), not the format that its name says"},
    {"Kaydara FBX Binary", "an FBX file"},
    {"BLENDER", "a Blender file"},
    {"3D Geometry File Format", "a Rhino 3DM file"},
    {"%PDF-", "a PDF document"},
    {"\x89PNG", "a PNG image"},
    {"\xff\xd8\xff", "a JPEG image"},
    {"GIF8", "a GIF image"},
    {"\x89kdgrid\n", "a saved grid (.kdgrid)"},
};

// In lower case; white space before them is passed over, and case does not count.
constexpr Beginning kText[] = {
    {"<!doctype html", "a web page (HTML)"},
    {"<html", "a web page (HTML)"},
    {"<head", "a web page (HTML)"},
    {"<body", "a web page (HTML)"},
    {"<script", "a web page (HTML)"},
    {"<", "an XML file"},
    {"{", "a JSON file"},
    {"iso-10303-21", "a STEP file"},
    {"; fbx ", "an FBX file"},
    {"#vrml", "a VRML file"},
    {"#x3d", "an X3D file"},
    {"xof 0", "a DirectX file"},
    {"# vtk datafile", "a VTK file"},
    {"$meshformat", "a Gmsh file"},
    {"0\nsection", "a DXF file"},
    {"0\r\nsection", "a DXF file"},
    {"cascade topology", "an OpenCASCADE BREP file"},
    {"dbrep_drawableshape", "an OpenCASCADE BREP file"},
    {"version https://git-lfs", "a Git LFS pointer, not the file that it stands for"},
};

struct Root {
  std::string_view tag;
  std::string_view what;
};

constexpr Root kXmlRoots[] = {{"<html", "a web page (HTML)"}, {"<collada", "a COLLADA file"},
                              {"<x3d", "an X3D file"},        {"<amf", "an AMF file"},
                              {"<svg", "an SVG drawing"},     {"<model", "a 3MF model"}};

bool begins(std::string_view text, std::string_view with) {
  return text.substr(0, with.size()) == with;
}

// A 3DS file is one chunk as long as the file, with a known chunk in it.
bool is_3ds(std::string_view bytes) {
  if (!begins(bytes, "MM") || bytes.size() < 16) return false;
  ByteReader reader(bytes, {}, ByteOrder::kLittle, 2);
  const auto length = reader.take_unsigned<std::uint32_t>();
  const auto chunk = reader.take_unsigned<std::uint16_t>();
  return length <= bytes.size() && (chunk == 0x0002 || chunk == 0x3d3d || chunk == 0x3d3e);
}

std::string_view foreign_binary(std::string_view bytes) {
  if (begins(bytes, "PK\x03\x04") || begins(bytes, "PK\x05\x06")) {
    // The names of an archive's files stand at its end as well.
    const bool is_3mf = bytes.find("3dmodel.model") != std::string_view::npos;
    return is_3mf ? "a 3MF file (a zip archive)" : "a zip archive; unpack it first";
  }
  if (is_3ds(bytes)) return "a 3DS file";
  for (const Beginning& known : kBinary) {
    if (begins(bytes, known.bytes)) return known.what;
  }
  return {};
}

std::string_view foreign_text(std::string_view lower) {
  const std::size_t first = lower.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  const std::string_view text = lower.substr(first);
  for (const Beginning& known : kText) {
    if (!begins(text, known.bytes)) continue;
    if (known.bytes == "<") {
      for (const Root& root : kXmlRoots) {
        if (text.find(root.tag) != std::string_view::npos) return root.what;
      }
    }
    if (known.bytes == "{" && text.find("\"asset\"") != std::string_view::npos) {
      return "glTF in JSON (.gltf); .glb files are read";
    }
    return known.what;
  }
  // IGES has lines of 80 letters, the first of which ends in the section and its number.
  if (text.size() == lower.size() && text.size() > 80 && text.substr(72, 8) == "s      1") {
    return "an IGES file";
  }
  return {};
}

bool is_off_keyword(std::string_view word) {
  for (const std::string_view prefix : {"st", "c", "n", "4", "n"}) {
    if (begins(word, prefix) && word != "off") word.remove_prefix(prefix.size());
  }
  return begins(word, "off") && (word.size() == 3 || (word[3] >= '0' && word[3] <= '9'));
}

bool is_number(TextScanner& scanner) {
  try {
    scanner.coordinate("a number");
    return true;
  } catch (const Error&) {
    return false;
  }
}

// Statements of OBJ, and among them a vertex.
bool is_obj(TextScanner scanner) {
  constexpr std::string_view kKeywords[] = {"vt", "vn", "vp", "f",  "l",      "p",      "o",
                                            "g",  "s",  "mg", "fo", "mtllib", "usemtl", "cstype"};
  while (scanner.find_word()) {
    const std::string_view keyword = scanner.word();
    if (keyword == "v") {
      int numbers = 0;
      while (numbers < 3 && is_number(scanner)) ++numbers;
      return numbers == 3;
    }
    if (std::find(std::begin(kKeywords), std::end(kKeywords), keyword) == std::end(kKeywords)) {
      return false;
    }
    scanner.skip_line();
  }
  return false;
}

std::optional<MeshFormat> format_of_text(std::string_view lower) {
  TextScanner scanner(lower, {}, {.comments = true, .continuations = true});
  if (!scanner.find_word()) return std::nullopt;
  TextScanner ahead = scanner;
  const std::string_view word = ahead.word();
  if (word == "ply" && ahead.at_line_end()) return MeshFormat::kPly;
  if (is_off_keyword(word)) return MeshFormat::kOff;
  if (word == "facet" && ahead.word() == "normal") return MeshFormat::kStl;
  if (word == "solid" && lower.find("facet") != std::string_view::npos) return MeshFormat::kStl;
  if (is_obj(scanner)) return MeshFormat::kObj;
  return std::nullopt;
}

}  // namespace

bool is_whole_binary_stl(std::string_view bytes) {
  constexpr std::size_t kHeader = 84;
  if (bytes.size() < kHeader) return false;
  ByteReader reader(bytes, {}, ByteOrder::kLittle, kHeader - 4);
  const std::uint64_t count = reader.take_unsigned<std::uint32_t>();
  return bytes.size() == kHeader + 50 * count;
}

Content sniff(std::string_view bytes) {
  if (is_whole_binary_stl(bytes)) return {MeshFormat::kStl, {}};
  if (const std::string_view what = foreign_binary(bytes); !what.empty()) return {{}, what};
  const std::string_view sample = without_padding(bytes).substr(0, kSample);
  // A PLY file has binary data behind its header.
  if (!looks_like_text(sample) && !begins(sample, "ply\n") && !begins(sample, "ply\r")) return {};
  std::string lower = lower_case(sample);
  if (begins(lower, "\xef\xbb\xbf")) lower.erase(0, 3);
  if (const std::string_view what = foreign_text(lower); !what.empty()) return {{}, what};
  return {format_of_text(lower), {}};
}

}  // namespace kdm
