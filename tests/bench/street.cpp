// SPDX-License-Identifier: MIT
#include "street.h"

#include <array>
#include <random>

#include "support/shapes.h"

namespace kdm::bench {
namespace {

using shapes::box;
using shapes::cylinder;
using shapes::translated;

constexpr double kPi = 3.14159265358979323846;
constexpr double kGap = 0.01;
constexpr int kPlotsPerStreet = 12;

void append(Mesh& scene, const Mesh& part) {
  const Index base = static_cast<Index>(scene.positions.size());
  scene.positions.insert(scene.positions.end(), part.positions.begin(), part.positions.end());
  for (const auto& [a, b, c] : part.triangles) {
    scene.triangles.push_back({a + base, b + base, c + base});
  }
}

// A box with a rectangular hole through its y direction: a window frame, or a wall with a window.
Mesh holed_box(const Vec3& min, const Vec3& max, double left, double right, double bottom,
               double top) {
  Mesh mesh;
  for (const double y : {min.y(), max.y()}) {
    for (const auto& [x0, x1, z0, z1] :
         {std::array{min.x(), max.x(), min.z(), max.z()}, std::array{left, right, bottom, top}}) {
      mesh.positions.insert(mesh.positions.end(),
                            {{x0, y, z0}, {x1, y, z0}, {x1, y, z1}, {x0, y, z1}});
    }
  }
  const auto quad = [&](Index a, Index b, Index c, Index d) {
    mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
  };
  // Corners 0-3 front outside, 4-7 front inside, 8-11 back outside, 12-15 back inside.
  for (Index i = 0; i < 4; ++i) {
    const Index j = (i + 1) % 4;
    quad(i, j, 4 + j, 4 + i);
    quad(12 + i, 12 + j, 8 + j, 8 + i);
    quad(8 + i, 8 + j, j, i);
    quad(4 + i, 4 + j, 12 + j, 12 + i);
  }
  return shapes::signed_volume(mesh) < 0 ? shapes::inverted(std::move(mesh)) : mesh;
}

Mesh roof(double width, double depth, double height) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0},     {width, 0, 0},          {width, depth, 0},
                    {0, depth, 0}, {0, depth / 2, height}, {width, depth / 2, height}};
  mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4},
                    {2, 3, 4}, {2, 4, 5}, {0, 4, 3}, {1, 2, 5}};
  return mesh;
}

// One bay of a front, 3 m high, from x on: wall with a window, its frame, cross bar and sill; or
// wall with a door standing before it.
void append_bay(Mesh& scene, double x, double z, double width, bool door) {
  const double left = x + width / 2 - 0.6;
  const double right = left + 1.2;
  const Vec3 low(x, 0, z);
  const Vec3 high(x + width - kGap, 0.24, z + 3 - kGap);
  if (door) {
    append(scene, box(low, high));
    append(scene, box(Vec3(left, -0.08, z), Vec3(right, -0.03, z + 2.1)));
    append(scene, translated(cylinder(0.02, 0.12, 8), Vec3(right - 0.1, -0.12, z + 1)));  // handle
    return;
  }
  append(scene, holed_box(low, high, left, right, z + 0.9, z + 2.3));
  const Vec3 outer_low(left + kGap, 0.08, z + 0.9 + kGap);
  const Vec3 outer_high(right - kGap, 0.14, z + 2.3 - kGap);
  append(scene, holed_box(outer_low, outer_high, left + 0.07, right - 0.07, z + 0.97, z + 2.23));
  append(scene, box(Vec3(left + 0.59, 0.1, z + 0.98), Vec3(left + 0.61, 0.12, z + 2.22)));
  append(scene, box(Vec3(left - 0.1, -0.2, z + 0.84), Vec3(right + 0.1, -kGap, z + 0.89)));
}

void append_house(Mesh& scene, std::mt19937& engine) {
  // Not std::uniform_real_distribution: it differs between standard libraries.
  const auto random = [&] { return static_cast<double>(engine()) / 4294967296.0; };
  const double width = 9 + 3 * random();
  const double depth = 7 + 3 * random();
  const int floors = 1 + static_cast<int>(random() * 3);
  const double height = 3.0 * floors;
  const int bays = 4;
  for (int floor = 0; floor < floors; ++floor) {
    const double z = 3.0 * floor;
    for (int bay = 0; bay < bays; ++bay) {
      append_bay(scene, width * bay / bays, z, width / bays, floor == 0 && bay == 1);
    }
    const double top = z + 3 - kGap;
    append(scene, box(Vec3(0, depth - 0.24, z), Vec3(width - kGap, depth, top)));
    for (const double x : {0.0, width - kGap - 0.24}) {
      append(scene, box(Vec3(x, 0.24 + kGap, z), Vec3(x + 0.24, depth - 0.24 - kGap, top)));
    }
  }
  append(scene, translated(roof(width + 0.8, depth + 0.8, 3), Vec3(-0.4, -0.4, height)));
  append(scene, box(Vec3(width * 0.7, depth * 0.5, height + 3.2),
                    Vec3(width * 0.76, depth * 0.5 + 0.6, height + 4.2)));  // chimney
}

void append_lamp(Mesh& scene, const Vec3& at) {
  append(scene, translated(cylinder(0.12, 0.4, 16), at));
  append(scene, translated(cylinder(0.04, 4, 16), at + Vec3(0, 0, 0.4 + kGap)));
  append(scene, translated(shapes::rotated(cylinder(0.02, 1.1, 12), Vec3::UnitY(), kPi / 2),
                           at + Vec3(0.05 + kGap, 0, 4.2)));
  append(scene, translated(shapes::icosphere(2, 0.2), at + Vec3(1.4, 0, 4.2)));
}

void append_fence(Mesh& scene, const Vec3& at, double length) {
  const int posts = static_cast<int>(length / 0.2);
  for (int i = 0; i <= posts; ++i) {
    append(scene, translated(box(Vec3::Zero(), Vec3(0.06, 0.02, 0.9)), at + Vec3(i * 0.2, 0, 0)));
  }
  for (const double z : {0.2, 0.7}) {
    append(scene, translated(box(Vec3(0, 0.03, z), Vec3(posts * 0.2, 0.05, z + 0.05)), at));
  }
}

}  // namespace

Mesh street_apart(Index triangles) {
  std::mt19937 engine(1);
  Mesh scene;
  for (int plot = 0; scene.triangles.size() < triangles; ++plot) {
    Mesh part;
    append_house(part, engine);
    part = translated(std::move(part), Vec3(0.5, 4, 0));
    append_fence(part, Vec3(0, 0, 0), 12);
    append_lamp(part, Vec3(0.4, -1.5, 0));
    append(part, box(Vec3(-0.4, -2.2, -0.15), Vec3(13.4, -2, 0)));  // kerb
    if (plot % 2 == 1) {                                            // the other side of the street
      part = translated(shapes::rotated(std::move(part), Vec3::UnitZ(), kPi), Vec3(13, -8, 0));
    }
    const int street = plot / kPlotsPerStreet;
    const int along = plot % kPlotsPerStreet / 2;
    append(scene, translated(std::move(part), Vec3(14.0 * along, 40.0 * street, 0)));
  }
  return scene;
}

}  // namespace kdm::bench
