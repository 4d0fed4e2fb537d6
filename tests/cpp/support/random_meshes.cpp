// SPDX-License-Identifier: MIT
#include "random_meshes.h"

#include <array>
#include <map>
#include <random>
#include <tuple>

#include "shapes.h"

namespace kdm::shapes {
namespace {

// std::uniform_*_distribution differs between standard libraries.
int below(std::mt19937& engine, int limit) {
  return static_cast<int>(engine() % static_cast<std::uint32_t>(limit));
}

Vec3 integer_point(std::mt19937& engine, int range) {
  const int x = below(engine, range + 1);
  const int y = below(engine, range + 1);
  const int z = below(engine, range + 1);
  return Vec3(x, y, z);
}

// Joins equal positions and leaves out faces that lose a corner by it: what remains is balanced,
// since the two directed edges that a lost face keeps are each other's reverse.
Mesh welded(const Mesh& mesh) {
  Mesh out;
  std::map<std::tuple<double, double, double>, Index> numbers;
  std::vector<Index> number(mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3& p = mesh.positions[v];
    const auto [entry, fresh] = numbers.try_emplace(std::tuple(p.x(), p.y(), p.z()),
                                                    static_cast<Index>(out.positions.size()));
    if (fresh) out.positions.push_back(p);
    number[v] = entry->second;
  }
  for (const Triangle& t : mesh.triangles) {
    const Triangle w{number[t[0]], number[t[1]], number[t[2]]};
    if (w[0] != w[1] && w[1] != w[2] && w[2] != w[0]) out.triangles.push_back(w);
  }
  return out;
}

}  // namespace

Mesh random_tetrahedra(int count, std::uint32_t seed) {
  std::mt19937 engine(seed);
  std::vector<Mesh> parts;
  for (int i = 0; i < count; ++i) {
    std::array<Vec3, 4> p;
    for (Vec3& corner : p) corner = integer_point(engine, 1 << 20) / (1 << 20);
    parts.push_back(tetrahedron(p[0], p[1], p[2], p[3]));
  }
  return merged(parts);
}

Mesh integer_tetrahedra(int count, int range, std::uint32_t seed) {
  std::mt19937 engine(seed);
  std::vector<Mesh> parts;
  for (int i = 0; i < count; ++i) {
    std::array<Vec3, 4> p;
    for (Vec3& corner : p) corner = integer_point(engine, range);
    Mesh part = tetrahedron(p[0], p[1], p[2], p[3]);
    parts.push_back(below(engine, 4) == 0 ? inverted(std::move(part)) : std::move(part));
  }
  return welded(merged(parts));
}

Mesh random_voxels(int size, double probability, std::uint32_t seed) {
  std::mt19937 engine(seed);
  std::vector<bool> filled(static_cast<std::size_t>(size * size * size));
  for (auto&& voxel : filled) voxel = static_cast<double>(engine()) < probability * 4294967296.0;
  return voxels(size, size, size, [&](int x, int y, int z) {
    return filled[static_cast<std::size_t>((z * size + y) * size + x)];
  });
}

Mesh collapsed_polyhedron(int range, std::uint32_t seed) {
  std::mt19937 engine(seed);
  Mesh mesh = icosphere(2);
  for (Vec3& p : mesh.positions) p = integer_point(engine, range);
  return welded(mesh);
}

Mesh mesh_from_bytes(const std::uint8_t* bytes, std::size_t size) {
  Mesh mesh;
  for (std::size_t i = 0; i + 12 <= size; i += 12) {
    const Index base = static_cast<Index>(mesh.positions.size());
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const std::uint8_t* p = bytes + i + 3 * corner;
      mesh.positions.emplace_back(p[0] & 63, p[1] & 63, p[2] & 63);
    }
    mesh.triangles.push_back({base, base + 1, base + 2});
    mesh.triangles.push_back({base, base + 3, base + 1});
    mesh.triangles.push_back({base + 1, base + 3, base + 2});
    mesh.triangles.push_back({base + 2, base + 3, base});
  }
  return welded(mesh);
}

}  // namespace kdm::shapes
