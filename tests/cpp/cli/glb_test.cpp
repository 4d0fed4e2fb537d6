// SPDX-License-Identifier: MIT
// GLB files: what is read of right ones, and that wrong ones are refused, whatever is in them.
#ifdef KDM_CLI_PATH

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <random>

#include "cli/glb/read.h"
#include "cli/glb/write.h"
#include "kdmanifold/error.h"
#include "support/mesh_assert.h"
#include "support/shapes.h"

namespace kdm::cli {
namespace {

using Json = nlohmann::json;

std::string word(std::uint32_t value) {
  std::string bytes;
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xff);
  return bytes;
}

std::string glb(std::string json, std::string binary) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  binary.resize((binary.size() + 3) / 4 * 4, '\0');
  const auto size = [](const std::string& text) { return static_cast<std::uint32_t>(text.size()); };
  return "glTF" + word(2) + word(28 + size(json) + size(binary)) + word(size(json)) + "JSON" +
         json + word(size(binary)) + std::string("BIN\0", 4) + binary;
}

template <typename Number>
std::string bytes_of(std::initializer_list<Number> numbers) {
  std::string bytes(numbers.size() * sizeof(Number), '\0');
  std::memcpy(bytes.data(), numbers.begin(), bytes.size());
  return bytes;
}

// A square of four points and six indices; tests change it.
struct Square {
  Json json = Json::parse(R"({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    "accessors": [
      {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
      {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteLength": 48},
                    {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
    "buffers": [{"byteLength": 60}]})");
  std::string binary = bytes_of<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) +
                       bytes_of<std::uint16_t>({0, 1, 2, 0, 2, 3});
  Json& node() { return json["nodes"][0]; }
  Json& primitive() { return json["meshes"][0]["primitives"][0]; }
  std::string bytes() const { return glb(json.dump(), binary); }
};

glb::Scene read(const Square& square) { return glb::read(square.bytes(), "a.glb"); }

std::string complaint(const std::string& bytes) {
  try {
    glb::read(bytes, "a.glb");
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kParseError);
    return error.what();
  }
  return "";
}
std::string complaint(const Square& square) { return complaint(square.bytes()); }

const std::vector<Triangle> kSquare = {{0, 1, 2}, {0, 2, 3}};

TEST(Glb, ReadsIndexedTriangles) {
  const glb::Scene scene = read(Square());
  EXPECT_EQ(scene.mesh.triangles, kSquare);
  EXPECT_EQ(scene.mesh.positions[2], Vec3(1, 1, 0));
  EXPECT_TRUE(scene.warnings.empty());
}

TEST(Glb, NodesMoveTurnAndMirror) {
  Square square;
  square.json["nodes"] = Json::parse(R"([
    {"children": [1], "translation": [10, 0, 0]},
    {"mesh": 0, "rotation": [0, 0, 1, 0], "scale": [2, 3, 4]}])");
  glb::Scene scene = read(square);
  EXPECT_EQ(scene.mesh.positions[2], Vec3(8, -3, 0));
  EXPECT_EQ(scene.mesh.triangles, kSquare);
  square.json["nodes"][1] = Json::parse(R"({"mesh": 0,
    "matrix": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 5, 1]})");
  scene = read(square);
  EXPECT_EQ(scene.mesh.positions[2], Vec3(9, 1, 5));
  EXPECT_EQ(scene.mesh.triangles, (std::vector<Triangle>{{0, 2, 1}, {0, 3, 2}}));
}

TEST(Glb, MeshesAreThereOnceANode) {
  Square square;
  square.json["nodes"] = Json::parse(R"([{"mesh": 0, "children": [1]}, {"mesh": 0}])");
  EXPECT_EQ(read(square).mesh.triangles.size(), 4u);
  EXPECT_EQ(read(square).mesh.positions.size(), 8u);
  square.json.erase("scenes");
  EXPECT_EQ(read(square).mesh.triangles.size(), 4u) << "all nodes, each once";
  square.json.erase("nodes");
  EXPECT_EQ(read(square).mesh.triangles, kSquare) << "all meshes";
}

TEST(Glb, PrimitivesShareTheirPoints) {
  Square square;
  square.json["meshes"][0]["primitives"].push_back(square.primitive());
  EXPECT_EQ(read(square).mesh.positions.size(), 4u);
  EXPECT_EQ(read(square).mesh.triangles.size(), 4u);
}

TEST(Glb, StripsFansAndPlainPoints) {
  Square square;
  square.json["accessors"][1]["count"] = 4;
  square.binary = square.binary.substr(0, 48) + bytes_of<std::uint16_t>({0, 1, 2, 3, 0, 0});
  square.primitive()["mode"] = 5;
  EXPECT_EQ(read(square).mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}}));
  square.primitive()["mode"] = 6;
  EXPECT_EQ(read(square).mesh.triangles, (std::vector<Triangle>{{1, 2, 0}, {2, 3, 0}}));
  square.primitive().erase("indices");
  EXPECT_EQ(read(square).mesh.triangles, (std::vector<Triangle>{{1, 2, 0}, {2, 3, 0}}));
  square.primitive()["mode"] = 4;
  EXPECT_EQ(complaint(square),
            "a.glb: meshes[0].primitives[0] has 4 corners, which is no multiple of 3");
}

TEST(Glb, IndicesOfAllTypes) {
  Square square;
  const std::string points = square.binary.substr(0, 48);
  square.binary = points + bytes_of<std::uint8_t>({0, 1, 2, 0, 2, 3});
  square.json["accessors"][1]["componentType"] = 5121;
  square.json["bufferViews"][1]["byteLength"] = 6;
  EXPECT_EQ(read(square).mesh.triangles, kSquare);
  square.binary = points + bytes_of<std::uint32_t>({0, 1, 2, 0, 2, 3});
  square.json["accessors"][1]["componentType"] = 5125;
  square.json["bufferViews"][1]["byteLength"] = 24;
  EXPECT_EQ(read(square).mesh.triangles, kSquare);
}

TEST(Glb, PointsOfOtherTypesAndBetweenOtherThings) {
  Square square;
  // Shorts with two bytes between them, as KHR_mesh_quantization has them.
  square.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  square.json["accessors"][0]["componentType"] = 5122;
  square.json["accessors"][0]["normalized"] = true;
  square.json["bufferViews"][0]["byteStride"] = 12;
  square.binary.replace(12, 6, bytes_of<std::int16_t>({32767, -32768, 0}));
  EXPECT_EQ(read(square).mesh.positions[1], Vec3(1, -1, 0));
  square.json["accessors"][0]["normalized"] = false;
  EXPECT_EQ(read(square).mesh.positions[1], Vec3(32767, -32768, 0));
}

TEST(Glb, SparseAccessors) {
  Square square;
  square.json["accessors"][0]["sparse"] = Json::parse(R"({"count": 1,
    "indices": {"bufferView": 2, "componentType": 5121}, "values": {"bufferView": 3}})");
  square.json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 60}, {"byteLength", 1}});
  square.json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 64}, {"byteLength", 12}});
  square.binary += word(2) + bytes_of<float>({7, 8, 9});
  EXPECT_EQ(read(square).mesh.positions[2], Vec3(7, 8, 9));
  EXPECT_EQ(read(square).mesh.positions[1], Vec3(1, 0, 0));
  square.json["accessors"][0].erase("bufferView");
  EXPECT_EQ(read(square).mesh.positions[1], Vec3(0, 0, 0));
  square.binary[60] = 4;
  EXPECT_EQ(complaint(square),
            "a.glb: accessors[0].sparse.indices has 4, but there are 4 elements");
}

TEST(Glb, WhatIsLeftOutIsSaid) {
  Square square;
  Json lines = square.primitive();
  lines["mode"] = 1;
  square.json["meshes"][0]["primitives"].push_back(lines);
  square.node()["skin"] = 0;
  const glb::Scene scene = read(square);
  EXPECT_EQ(scene.mesh.triangles, kSquare);
  EXPECT_EQ(scene.warnings,
            (std::vector<Warning>{
                {"NOT_READ", "1 primitives without triangles (points or lines) are left out"},
                {"NOT_READ", "skins are left out: meshes are as they were modelled"}}));
}

TEST(Glb, RefusesWithAReason) {
  const auto changed = [](const char* pointer, const Json& value) {
    Square square;
    square.json[Json::json_pointer(pointer)] = value;
    return complaint(square);
  };
  EXPECT_NE(changed("/extensionsRequired", {"KHR_draco_mesh_compression"}).find("compressed by"),
            std::string::npos);
  EXPECT_EQ(changed("/extensionsRequired", {"EXT_meshopt_compression"}),
            "a.glb: it is compressed by EXT_meshopt_compression; save it without compression");
  EXPECT_EQ(changed("/extensionsRequired", {"KHR_unheard_of"}),
            "a.glb: it needs the extension KHR_unheard_of, which is not supported");
  EXPECT_EQ(changed("/extensionsRequired", {"KHR_materials_unlit"}), "");
  EXPECT_EQ(changed("/buffers/0/uri", "a.bin"),
            "a.glb: buffers[0] is not in the file but in a.bin; only what is in it is read");
  EXPECT_EQ(changed("/nodes", 5), "a.glb: the JSON: nodes is no list");
  EXPECT_EQ(changed("/nodes/0/children", {0}), "a.glb: nodes[0] has two parents");
  EXPECT_EQ(changed("/nodes/0/mesh", 1), "a.glb: nodes[0] refers to meshes[1], but there are 1");
  EXPECT_EQ(changed("/nodes/0/mesh", -1), "a.glb: nodes[0].mesh is no whole number from 0 on");
  EXPECT_EQ(changed("/nodes/0/scale", {1, 2}), "a.glb: nodes[0].scale is no list of 3 numbers");
  EXPECT_EQ(changed("/accessors/0/count", 5), "a.glb: accessors[0] goes beyond bufferViews[0]");
  EXPECT_EQ(changed("/accessors/0/count", 9e15), "a.glb: accessors[0].count is too large");
  EXPECT_EQ(changed("/accessors/0/type", "VEC2"), "a.glb: accessors[0].type is not VEC3");
  EXPECT_EQ(changed("/accessors/0/byteOffset", 2),
            "a.glb: accessors[0] is not aligned to the size of its numbers");
  EXPECT_EQ(changed("/bufferViews/0/byteLength", 99),
            "a.glb: bufferViews[0] goes beyond the 60 bytes of binary data");
  EXPECT_EQ(changed("/bufferViews/0/byteStride", 8),
            "a.glb: bufferViews[0].byteStride is less than an element");
  Square square;
  square.binary[48] = 9;
  EXPECT_EQ(complaint(square),
            "a.glb: meshes[0].primitives[0]: index 9 is out of range, there are 4 "
            "vertices");
  square.binary.replace(16, 4, word(0xffc00000));  // not a number
  EXPECT_EQ(complaint(square), "a.glb: meshes[0].primitives[0]: vertex 1 lies at no finite place");
  EXPECT_EQ(changed("/nodes/0/scale", {1e200, 1, 1}),
            "a.glb: meshes[0].primitives[0]: vertex 1 lies at no finite place");
  EXPECT_EQ(complaint(""), "a.glb: byte 0: a GLB file begins with 'glTF'");
  EXPECT_EQ(complaint("{\"asset\""), "a.glb: it is a .gltf file; .glb files are supported");
  EXPECT_EQ(complaint("glTF" + word(1) + word(12)),
            "a.glb: byte 4: it is of version 1; 2 is supported");
  EXPECT_EQ(complaint(glb("{", "")), "a.glb: byte 20: the JSON is malformed");
}

TEST(Glb, DeepNestingIsNoTrouble) {
  Square square;
  const std::string deep = std::string(200000, '[') + std::string(200000, ']');
  std::string json = square.json.dump();
  json.insert(1, "\"extras\":" + deep + ",");
  EXPECT_EQ(glb::read(glb(json, square.binary), "a.glb").mesh.triangles, kSquare);
}

TEST(Glb, TruncatedFilesAreRefused) {
  const std::string whole = Square().bytes();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_NE(complaint(whole.substr(0, size)), "") << size;
  }
}

// A mesh or a refusal; sanitizers see what else there may be.
TEST(Glb, DamagedFilesAreReadOrRefused) {
  Square square;
  square.json["accessors"][0]["sparse"] = Json::parse(R"({"count": 1,
    "indices": {"bufferView": 2, "componentType": 5121}, "values": {"bufferView": 3}})");
  square.json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 60}, {"byteLength", 1}});
  square.json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 64}, {"byteLength", 12}});
  square.binary += word(2) + bytes_of<float>({7, 8, 9});
  const std::string whole = square.bytes();
  std::mt19937 random(1);
  int refused = 0, taken = 0;
  for (int attempt = 0; attempt < 20000; ++attempt) {
    std::string bytes = whole;
    for (unsigned i = 0; i <= random() % 3; ++i) {
      char& byte = bytes[random() % bytes.size()];
      // Digits for digits, so that much of it stays JSON.
      byte = byte >= '0' && byte <= '9' ? static_cast<char>('0' + random() % 10)
                                        : static_cast<char>(byte ^ 1 << random() % 8);
    }
    try {
      const Mesh mesh = glb::read(bytes, "a.glb").mesh;
      for (const Triangle& t : mesh.triangles) {
        for (const Index vertex : t) ASSERT_LT(vertex, mesh.positions.size());
      }
      ++taken;
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).rfind("a.glb: ", 0), 0u);
      ++refused;
    }
  }
  EXPECT_GT(refused, 1000);
  EXPECT_GT(taken, 1000);
}

TEST(Glb, WhatIsWrittenIsRead) {
  Mesh mesh = shapes::torus();
  for (Vec3& p : mesh.positions) p = p.cast<float>().cast<double>();
  const std::string bytes = glb::write(mesh);
  EXPECT_EQ(bytes.size() % 4, 0u);
  const Mesh again = glb::read(bytes, "a.glb").mesh;
  EXPECT_EQ(again.positions, mesh.positions);
  EXPECT_EQ(again.triangles, mesh.triangles);
}

TEST(Glb, QuadsAreCutAndNormalsSplitVertices) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
  mesh.triangles = {{0, 1, 4}};
  mesh.quads = {{0, 1, 2, 3}};
  const Mesh plain = glb::read(glb::write(mesh), "a.glb").mesh;
  EXPECT_EQ(plain.positions.size(), 5u);
  EXPECT_EQ(plain.triangles, (std::vector<Triangle>{{0, 1, 4}, {0, 1, 2}, {0, 2, 3}}));
  const std::array<float, 3> up = {0, 0, 1}, front = {0, -1, 0};
  mesh.corner_normals = {front, front, front, up, front, up, up};
  const Mesh split = glb::read(glb::write(mesh), "a.glb").mesh;
  // Vertex 0 is there twice, vertex 1 once.
  EXPECT_EQ(split.positions.size(), 6u);
  EXPECT_EQ(split.triangles, (std::vector<Triangle>{{0, 1, 2}, {3, 1, 4}, {3, 4, 5}}));
  EXPECT_EQ(split.positions[3], Vec3(0, 0, 0));
}

TEST(Glb, BoundsAreExactAndIndicesShort) {
  Mesh mesh;
  mesh.positions = {{-0.0, 0.1f, 1e-20f}, {0.5, 3, 16777216}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  const std::string bytes = glb::write(mesh);
  const Json json = Json::parse(bytes.substr(20, bytes.find("BIN") - 24));
  const Json& points = json["accessors"][0];
  EXPECT_EQ(points["min"][1].get<double>(), 0.1f);
  EXPECT_EQ(points["max"], Json({0.5, 3.0, 16777216.0}));
  EXPECT_EQ(points["min"][0].dump(), "0");
  EXPECT_EQ(json["accessors"][1]["componentType"], 5123);
  mesh.positions.resize(65536, Vec3(0, 0, 0));
  const std::string large = glb::write(mesh);
  EXPECT_NE(large.find("\"componentType\":5125"), std::string::npos);
  mesh.positions[0][1] = 1e200;
  EXPECT_THROW(glb::write(mesh), Error);
}

}  // namespace
}  // namespace kdm::cli

#endif  // KDM_CLI_PATH
