// SPDX-License-Identifier: MIT
// Makes the bytes of GLB files. cli-glb-write.ts makes the same ones.
#include "cli/glb/write.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstring>

#include "kdmanifold/error.h"

namespace kdm::cli::glb {
namespace {

using Point = std::array<float, 3>;

// What goes into the file.
struct Model {
  std::vector<Point> positions;
  std::vector<Point> normals;  // one a position, or none at all
  std::vector<Index> indices;
};

Point single(const Vec3& p, std::size_t index) {
  Point point{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double value = p[static_cast<Eigen::Index>(axis)];
    point[axis] = static_cast<float>(value);
    if (std::isfinite(point[axis])) continue;
    throw Error(ErrorCode::kInvalidMesh,
                fmt::format("positions[{}].{} is no finite 32-bit number; scale the mesh down",
                            index, "xyz"[axis]));
  }
  return point;
}

// Calls `visit(corner, vertex)` for the corners of all triangles, those of halved quads among them;
// `corner` is the corner's number in the mesh.
template <typename Visit>
void for_each_corner(const Mesh& mesh, Visit&& visit) {
  std::size_t corner = 0;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) visit(corner + i, t[i]);
    corner += 3;
  }
  for (const Quad& q : mesh.quads) {
    for (const std::size_t i : {0, 1, 2, 0, 2, 3}) visit(corner + i, q[i]);
    corner += 4;
  }
}

// The copies of each vertex, one a normal, as chains through the new vertices.
Model split(const Mesh& mesh, const std::vector<Point>& positions) {
  Model model;
  std::vector<Index> first(positions.size(), kNone), next;
  for_each_corner(mesh, [&](std::size_t corner, Index vertex) {
    const Point& normal = mesh.corner_normals[corner];
    Index copy = first[vertex];
    while (copy != kNone && model.normals[copy] != normal) copy = next[copy];
    if (copy == kNone) {
      copy = static_cast<Index>(model.positions.size());
      model.positions.push_back(positions[vertex]);
      model.normals.push_back(normal);
      next.push_back(first[vertex]);
      first[vertex] = copy;
    }
    model.indices.push_back(copy);
  });
  return model;
}

Model model_of(const Mesh& mesh) {
  std::vector<Point> positions;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    positions.push_back(single(mesh.positions[i], i));
  }
  if (!mesh.corner_normals.empty()) return split(mesh, positions);
  Model model{std::move(positions), {}, {}};
  for_each_corner(mesh, [&](std::size_t, Index vertex) { model.indices.push_back(vertex); });
  return model;
}

// The shortest digits that read back as the number: 0.5 is 5e-1, as JavaScript writes it too.
std::string number_text(float value) {
  char text[64];
  const double exact = static_cast<double>(value) + 0.0;  // no -0
  const auto end = std::to_chars(text, text + sizeof text, exact, std::chars_format::scientific);
  std::string digits(text, end.ptr);
  const std::size_t e = digits.find('e');
  std::string exponent = digits.substr(e + 1);  // a sign and at least two digits
  while (exponent.size() > 2 && exponent[1] == '0') exponent.erase(1, 1);
  if (exponent == "+0") return digits.substr(0, e);
  return digits.substr(0, e + 1) + exponent;
}

std::string point_text(const Point& p) {
  return fmt::format("[{},{},{}]", number_text(p[0]), number_text(p[1]), number_text(p[2]));
}

void append_u32(std::string& out, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>(value >> shift & 0xff);
}

void append_points(std::string& out, const std::vector<Point>& points) {
  for (const Point& p : points) {
    for (const float value : p) {
      std::uint32_t bits;
      std::memcpy(&bits, &value, sizeof bits);
      append_u32(out, bits);
    }
  }
}

// The text that describes the arrays, which follow each other without gaps.
std::string description(const Model& model, std::size_t index_bytes, std::size_t bytes) {
  Point low = model.positions[0], high = low;
  for (const Point& p : model.positions) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (p[axis] < low[axis]) low[axis] = p[axis];
      if (p[axis] > high[axis]) high[axis] = p[axis];
    }
  }
  const bool normals = !model.normals.empty();
  const std::size_t count = model.positions.size();
  const std::size_t indices_at = 12 * count * (normals ? 2 : 1);
  std::string text =
      R"({"asset":{"version":"2.0","generator":"kdmanifold"},"scene":0,"scenes":[{"nodes":[0]}],)"
      R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0)";
  text += fmt::format(R"({}}},"indices":{}}}]}}],"accessors":[)", normals ? R"(,"NORMAL":1)" : "",
                      normals ? 2 : 1);
  text += fmt::format(
      R"({{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3","min":{},"max":{}}},)",
      count, point_text(low), point_text(high));
  if (normals) {
    text +=
        fmt::format(R"({{"bufferView":1,"componentType":5126,"count":{},"type":"VEC3"}},)", count);
  }
  text += fmt::format(R"({{"bufferView":{},"componentType":{},"count":{},"type":"SCALAR"}}],)",
                      normals ? 2 : 1, index_bytes == 2 ? 5123 : 5125, model.indices.size());
  text += R"("bufferViews":[)";
  for (std::size_t i = 0; i < (normals ? 2u : 1u); ++i) {
    text += fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{},"target":34962}},)",
                        12 * count * i, 12 * count);
  }
  text += fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{},"target":34963}}],)",
                      indices_at, index_bytes * model.indices.size());
  return text + fmt::format(R"("buffers":[{{"byteLength":{}}}]}})", bytes);
}

}  // namespace

std::string write(const Mesh& mesh) {
  const Model model = model_of(mesh);
  const bool empty = model.indices.empty();
  // 65535 marks the end of strips and is no index.
  const std::size_t index_bytes = model.positions.size() <= 65535 ? 2 : 4;
  std::string binary;
  if (!empty) {
    append_points(binary, model.positions);
    append_points(binary, model.normals);
    for (const Index index : model.indices) {
      append_u32(binary, index);
      if (index_bytes == 2) binary.resize(binary.size() - 2);
    }
  }
  const std::size_t bytes = binary.size();
  binary.resize((bytes + 3) / 4 * 4, '\0');
  std::string json = empty ? R"({"asset":{"version":"2.0","generator":"kdmanifold"}})"
                           : description(model, index_bytes, bytes);
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::size_t length = 20 + json.size() + (empty ? 0 : 8 + binary.size());
  if (length > 0xffffffffu) {
    throw Error(ErrorCode::kInvalidMesh, "the mesh is too large for a GLB file: 4 GiB or more");
  }
  std::string out = "glTF";
  out.reserve(length);
  append_u32(out, 2);
  append_u32(out, static_cast<std::uint32_t>(length));
  append_u32(out, static_cast<std::uint32_t>(json.size()));
  out += "JSON";
  out += json;
  if (empty) return out;
  append_u32(out, static_cast<std::uint32_t>(binary.size()));
  out.append("BIN\0", 4);
  return out + binary;
}

}  // namespace kdm::cli::glb
