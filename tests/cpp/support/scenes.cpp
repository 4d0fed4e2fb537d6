// SPDX-License-Identifier: MIT
// The composed shapes of shapes.h and the list of them all.
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "random_meshes.h"
#include "shapes.h"

namespace kdm::shapes {
namespace {

void append(Mesh& scene, const Mesh& part) {
  const Index base = static_cast<Index>(scene.positions.size());
  scene.positions.insert(scene.positions.end(), part.positions.begin(), part.positions.end());
  for (const Triangle& t : part.triangles) {
    scene.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
}

// A rectangular ring in the plane y = 0, as a window frame is: genus 1.
Mesh frame(double width, double height, double bar, double depth) {
  Mesh mesh;
  for (int layer = 0; layer < 2; ++layer) {
    for (int ring = 0; ring < 2; ++ring) {
      const double inset = ring * bar;
      const double y = layer * depth;
      mesh.positions.emplace_back(inset, y, inset);
      mesh.positions.emplace_back(width - inset, y, inset);
      mesh.positions.emplace_back(width - inset, y, height - inset);
      mesh.positions.emplace_back(inset, y, height - inset);
    }
  }
  const auto quad = [&](Index a, Index b, Index c, Index d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  for (Index i = 0; i < 4; ++i) {
    const Index j = (i + 1) % 4;
    quad(i, j, 4 + j, 4 + i);            // front
    quad(12 + i, 12 + j, 8 + j, 8 + i);  // back
    quad(8 + i, 8 + j, j, i);            // outer rim
    quad(4 + i, 4 + j, 12 + j, 12 + i);  // inner rim
  }
  return signed_volume(mesh) < 0 ? inverted(std::move(mesh)) : mesh;
}

Mesh roof(double width, double depth, double height) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0},     {width, 0, 0},          {width, depth, 0},
                    {0, depth, 0}, {0, depth / 2, height}, {width, depth / 2, height}};
  mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4},
                    {2, 3, 4}, {2, 4, 5}, {0, 4, 3}, {1, 2, 5}};
  return mesh;
}

Mesh house(std::mt19937& engine) {
  const auto random = [&] { return static_cast<double>(engine()) / 4294967296.0; };
  const double width = 8 + 4 * random();
  const double depth = 7 + 3 * random();
  const int floors = 1 + static_cast<int>(random() * 3);
  const double height = 3.0 * floors;
  Mesh mesh = box(Vec3::Zero(), Vec3(width, depth, height));
  append(mesh, translated(roof(width + 0.8, depth + 0.8, 3), Vec3(-0.4, -0.4, height)));
  append(mesh, box(Vec3(width * 0.7, depth * 0.4, height + 1), Vec3(width * 0.78, depth * 0.5,
                                                                    height + 4)));  // chimney
  for (int floor = 0; floor < floors; ++floor) {
    for (int i = 0; i < 4; ++i) {
      const double x = 0.6 + i * (width - 1) / 4;
      const double z = floor * 3.0 + 0.9;
      if (floor == 0 && i == 1) {
        append(mesh, box(Vec3(x, -0.06, 0), Vec3(x + 1, 0.02, 2.1)));  // the door stands out
        continue;
      }
      append(mesh, translated(frame(1.2, 1.4, 0.07, 0.08), Vec3(x, -0.08, z)));
      append(mesh, box(Vec3(x - 0.1, -0.25, z - 0.06), Vec3(x + 1.3, 0, z)));  // sill
      append(mesh, box(Vec3(x + 0.57, -0.05, z + 0.07), Vec3(x + 0.63, -0.03, z + 1.33)));
    }
  }
  return mesh;
}

Mesh lamp() {
  Mesh mesh = cylinder(0.12, 0.4, 16);
  append(mesh, cylinder(0.05, 4.5, 16));
  append(mesh, translated(rotated(cylinder(0.03, 1.2, 12), Vec3::UnitY(), std::numbers::pi / 2),
                          Vec3(-0.02, 0, 4.4)));
  append(mesh, translated(icosphere(2, 0.2), Vec3(1.2, 0, 4.3)));
  return mesh;
}

Mesh fence(double length) {
  Mesh mesh;
  const int posts = static_cast<int>(length / 0.2);
  for (int i = 0; i <= posts; ++i) {
    const double x = i * 0.2;
    append(mesh, box(Vec3(x, 0, 0), Vec3(x + 0.06, 0.02, 0.9)));
  }
  for (const double z : {0.2, 0.7}) {
    append(mesh, box(Vec3(0, 0.015, z), Vec3(posts * 0.2 + 0.06, 0.035, z + 0.05)));
  }
  return mesh;
}

}  // namespace

Mesh torus_chain(int links) {
  Mesh chain;
  for (int i = 0; i < links; ++i) {
    Mesh link = torus(1, 0.25, 40, 16);
    if (i % 2 == 1) link = rotated(std::move(link), Vec3::UnitX(), std::numbers::pi / 2);
    append(chain, translated(std::move(link), Vec3(1.4 * i, 0, 0)));
  }
  return chain;
}

Mesh plate_with_holes(int nx, int ny) {
  return voxels(2 * nx + 1, 2 * ny + 1, 1, [](int x, int y, int) { return !(x % 2 && y % 2); });
}

Mesh stairs(int steps) {
  return voxels(steps, 2, steps, [](int x, int, int z) { return z <= x; });
}

Mesh nested_spheres() { return merged({icosphere(3, 1), inverted(icosphere(3, 0.7))}); }

Mesh nested_shells() { return merged({icosphere(3, 1), icosphere(3, 0.7)}); }

Mesh thin_walled_box(double wall) {
  const Vec3 inset = Vec3::Constant(wall);
  return merged({cube(), inverted(box(inset, Vec3::Ones() - inset))});
}

Mesh glass(double wall) {
  // Height 1; foot, stem, bowl outside up to the rim, bowl inside down to the axis.
  std::vector<std::pair<double, double>> profile = {
      {0, 0}, {0.3, 0}, {0.3, 0.02}, {0.04, 0.06}, {0.03, 0.4}};
  constexpr int kSteps = 12;
  const auto bowl = [](double angle, double radius) {
    return std::pair(radius * sine(angle), 0.75 - radius * cosine(angle));
  };
  for (int i = 2; i <= kSteps; ++i)
    profile.push_back(bowl(std::numbers::pi / 2 * i / kSteps, 0.35));
  profile.emplace_back(0.35, 1.0);
  profile.emplace_back(0.35 - wall, 1.0);
  for (int i = kSteps; i > 0; --i)
    profile.push_back(bowl(std::numbers::pi / 2 * i / kSteps, 0.35 - wall));
  profile.emplace_back(0, 0.75 - (0.35 - wall));
  return revolved(profile, 48);
}

Mesh overlapping_cubes() { return merged({cube(), translated(cube(), Vec3::Constant(0.5))}); }

Mesh face_to_face_cubes() { return merged({cube(), translated(cube(), Vec3::UnitX())}); }

Mesh doubled_cube() {
  Mesh mesh = cube();
  const std::vector<Triangle> once = mesh.triangles;
  mesh.triangles.insert(mesh.triangles.end(), once.begin(), once.end());
  return mesh;
}

Mesh cube_with_flaps() {
  Mesh mesh = cube();
  const auto flap = [&](Index a, Index b, const Vec3& tip) {
    const Index c = static_cast<Index>(mesh.positions.size());
    mesh.positions.push_back(tip);
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, b});
  };
  flap(0, 1, Vec3(0.4, -0.7, 0.1));  // a fin outside
  flap(6, 7, Vec3(0.5, 0.4, 0.45));  // one inside
  flap(1, 3, Vec3(1, 0.5, 0.5));     // one in a face's plane
  return mesh;
}

Mesh cubes_at_vertex() {
  Mesh mesh = merged({cube(), translated(cube(), Vec3::Ones())});
  for (Triangle& t : mesh.triangles) {
    for (Index& v : t) {
      if (v == 8) v = 7;
      if (v > 8) --v;
    }
  }
  mesh.positions.erase(mesh.positions.begin() + 8);
  return mesh;
}

Mesh cubes_at_edge() {
  return voxels(2, 2, 1, [](int x, int y, int) { return x == y; });
}

Mesh swiss_cheese(int cavities, std::uint32_t seed) {
  std::mt19937 engine(seed);
  const auto random = [&] { return static_cast<double>(engine()) / 4294967296.0; };
  Mesh mesh = cube();
  std::vector<std::pair<Vec3, double>> balls;
  while (static_cast<int>(balls.size()) < cavities) {
    const double radius = 0.04 + 0.08 * random();
    const double x = random();
    const double y = random();
    const double z = random();
    const Vec3 centre = Vec3::Constant(radius + 0.02) + Vec3(x, y, z) * (1 - 2 * (radius + 0.02));
    bool free = true;
    for (const auto& [other, r] : balls) {
      free = free && (other - centre).norm() > r + radius + 0.02;
    }
    if (!free) continue;
    balls.emplace_back(centre, radius);
    append(mesh, inverted(translated(icosphere(2, radius), centre)));
  }
  return mesh;
}

Mesh street(Index triangles) {
  std::mt19937 engine(1);
  Mesh scene;
  const Mesh pole = lamp();
  const Mesh yard = fence(11);
  for (int plot = 0; scene.triangles.size() < triangles; ++plot) {
    const bool far_side = plot % 2 == 1;
    Mesh part = translated(house(engine), Vec3(1, 4, 0));
    append(part, yard);
    append(part, translated(pole, Vec3(0.4, -1.5, 0)));
    append(part, box(Vec3(-1, -2.2, -0.15), Vec3(13, -2, 0)));  // kerb
    if (far_side)
      part = translated(rotated(std::move(part), Vec3::UnitZ(), std::numbers::pi), Vec3(12, -8, 0));
    append(scene, translated(std::move(part), Vec3(14.0 * (plot / 2), 0, 0)));
  }
  return scene;
}

std::vector<NamedShape> all_shapes() {
  std::vector<NamedShape> list;
  const auto embedded = [&](std::string name, Mesh mesh, Index components, int euler) {
    const double volume = signed_volume(mesh);
    list.push_back({std::move(name), std::move(mesh), volume, components, euler, true});
  };
  const auto touching = [&](std::string name, Mesh mesh, std::optional<double> volume,
                            std::optional<Index> components = {}, std::optional<int> euler = {}) {
    list.push_back({std::move(name), std::move(mesh), volume, components, euler, false});
  };
  embedded("cube", cube(), 1, 2);
  embedded("cube_rotated", rotated(cube(), Vec3(1, 2, 3), 0.7), 1, 2);
  embedded("cube_dyadic", scaled(cube(), Vec3(0.5, 0.25, 1)), 1, 2);
  embedded("cube_subdivided", subdivided(subdivided(cube())), 1, 2);
  embedded("tetrahedron", tetrahedron(), 1, 2);
  embedded("icosphere", icosphere(3), 1, 2);
  embedded("icosphere_snapped", snapped(icosphere(3), 1.0 / 16), 1, 2);
  embedded("uv_sphere", uv_sphere(32, 16), 1, 2);
  embedded("cylinder", cylinder(0.5, 2, 24), 1, 2);
  embedded("torus", torus(), 1, 0);
  embedded("torus_chain", torus_chain(3), 3, 0);
  embedded("plate_with_holes", plate_with_holes(4, 3), 1, 2 - 2 * 12);
  embedded("stairs", stairs(6), 1, 2);
  embedded("nested_spheres", nested_spheres(), 2, 4);
  embedded("thin_walled_box", thin_walled_box(), 2, 4);
  embedded("glass", glass(), 1, 2);
  embedded("swiss_cheese", swiss_cheese(12), 13, 26);
  touching("nested_shells", nested_shells(), signed_volume(icosphere(3)), 1, 2);
  touching("overlapping_cubes", overlapping_cubes(), 2 - 0.125, 1, 2);
  touching("face_to_face_cubes", face_to_face_cubes(), 2);
  touching("doubled_cube", doubled_cube(), 1, 1, 2);
  touching("cube_with_flaps", cube_with_flaps(), 1);
  touching("cubes_at_vertex", cubes_at_vertex(), 2);
  touching("cubes_at_edge", cubes_at_edge(), 2);
  touching("street", street(4000), {});
  touching("tetrahedra_soup", random_tetrahedra(40, 7), {});
  touching("integer_tetrahedra", integer_tetrahedra(30, 4, 7), {});
  touching("random_voxels", random_voxels(6, 0.5, 7), {});
  touching("collapsed_polyhedron", collapsed_polyhedron(3, 7), {});
  return list;
}

}  // namespace kdm::shapes
