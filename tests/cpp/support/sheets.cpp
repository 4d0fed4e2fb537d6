// SPDX-License-Identifier: MIT
#include "support/sheets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace kdm::shapes {

Mesh grid_sheet(int nx, int ny, const std::function<double(double, double)>& height,
                const std::function<bool(int, int)>& missing) {
  Mesh mesh;
  for (int j = 0; j <= ny; ++j) {
    for (int i = 0; i <= nx; ++i) {
      const double x = static_cast<double>(i) / nx;
      const double y = static_cast<double>(j) / ny;
      mesh.positions.emplace_back(x, y, height(x, y));
    }
  }
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      if (missing(i, j)) continue;
      const auto a = static_cast<Index>(j * (nx + 1) + i);
      const auto c = static_cast<Index>(a + static_cast<Index>(nx) + 1);
      mesh.triangles.push_back({a, a + 1, c + 1});
      mesh.triangles.push_back({a, c + 1, c});
    }
  }
  return mesh;
}

Mesh grid_sheet(int nx, int ny, const std::function<double(double, double)>& height) {
  return grid_sheet(nx, ny, height, [](int, int) { return false; });
}

Mesh moebius_band(int segments) {
  Mesh mesh;
  for (int i = 0; i < segments; ++i) {
    const double angle = 2 * std::numbers::pi * i / segments;
    for (const double side : {-0.3, 0.3}) {
      const double radius = 1 + side * cosine(angle / 2);
      mesh.positions.emplace_back(radius * cosine(angle), radius * sine(angle),
                                  side * sine(angle / 2));
    }
  }
  const auto count = static_cast<Index>(2 * segments);
  for (Index i = 0; i < static_cast<Index>(segments); ++i) {
    const Index a = 2 * i;
    Index c = (a + 2) % count;
    Index d = c + 1;
    if (i + 1 == static_cast<Index>(segments)) std::swap(c, d);  // the half turn
    mesh.triangles.push_back({a, c, d});
    mesh.triangles.push_back({a, d, a + 1});
  }
  return mesh;
}

Mesh tube(double radius, double height, int segments) {
  Mesh mesh;
  for (int i = 0; i < segments; ++i) {
    const double angle = 2 * std::numbers::pi * i / segments;
    for (const double z : {0.0, height}) {
      mesh.positions.emplace_back(radius * cosine(angle), radius * sine(angle), z);
    }
  }
  const auto count = static_cast<Index>(2 * segments);
  for (Index i = 0; i < count; i += 2) {
    const Index next = (i + 2) % count;
    mesh.triangles.push_back({i, next, next + 1});
    mesh.triangles.push_back({i, next + 1, i + 1});
  }
  return mesh;
}

std::vector<OpenShape> open_shapes() {
  const Vec3 axis(1, 2, 3);
  const auto wave = [](double x, double y) { return 0.2 * sine(5 * x) * cosine(4 * y); };
  const auto flat = [](double, double) { return 0.0; };
  const auto hole = [](int i, int j) { return i >= 3 && i < 6 && j >= 2 && j < 5; };
  Mesh lidless = cube();
  // The two triangles of the side at z = 1.
  std::erase_if(lidless.triangles, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](Index v) { return lidless.positions[v].z() == 1; });
  });
  const Mesh square = grid_sheet(1, 1, flat);
  const Mesh strip = scaled(square, Vec3(1, 0.05, 1));
  const Mesh crossing =
      merged({square, rotated(translated(square, Vec3(-0.5, -0.4, 0)), Vec3(0, 1, 0), 1.2)});
  return {
      {"square", square, 1, 1, 1},
      {"square_turned", rotated(square, axis, 0.9), 1, 1, 1},
      {"strip", rotated(strip, axis, 0.9), 1, 1, 1},
      {"wave", grid_sheet(16, 16, wave), 1, 1, 1},
      {"wave_with_hole", rotated(grid_sheet(10, 10, wave, hole), axis, 0.4), 1, 2, 0},
      {"flat_with_hole", grid_sheet(10, 10, flat, hole), 1, 2, 0},
      {"tube", rotated(tube(0.4, 1, 40), axis, 0.6), 1, 2, 0},
      {"lidless_cube", lidless, 1, 1, 1},
      {"lidless_cube_turned", rotated(lidless, axis, 0.8), 1, 1, 1},
      {"open_ball", rotated(open(icosphere(3), 200), axis, 0.5), 1, 3, -1},
      {"open_torus", open(torus(1, 0.4, 30, 16), 150), 1, 2, 0},
      {"two_sheets", merged({square, translated(square, Vec3(0.1, 0.1, 0.02))}), 2, 2, 2},
      {"crossing_sheets", crossing, 2, 2, 2},
  };
}

}  // namespace kdm::shapes

namespace kdm::check {
namespace {

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double square = along.squaredNorm();
  const double s = square > 0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0.0;
  return (p - a - s * along).norm();
}

double distance_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  const bool above = normal.cross(b - a).dot(p - a) >= 0 && normal.cross(c - b).dot(p - b) >= 0 &&
                     normal.cross(a - c).dot(p - c) >= 0;
  if (above && normal.norm() > 0) return std::abs(normal.dot(p - a)) / normal.norm();
  return std::min(
      {distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

std::vector<std::pair<Vec3, Vec3>> rim_of(const Mesh& mesh) {
  // By position: the inputs of tests may not be welded.
  const auto less = [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  };
  std::map<Vec3, Index, decltype(less)> number(less);
  std::map<std::pair<Index, Index>, int> uses;
  std::map<std::pair<Index, Index>, std::pair<Vec3, Vec3>> ends;
  for (const Triangle& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const Vec3& a = mesh.positions[t[i]];
      const Vec3& b = mesh.positions[t[(i + 1) % 3]];
      const Index m = number.emplace(a, static_cast<Index>(number.size())).first->second;
      const Index n = number.emplace(b, static_cast<Index>(number.size())).first->second;
      ++uses[std::minmax(m, n)];
      ends[std::minmax(m, n)] = {a, b};
    }
  }
  std::vector<std::pair<Vec3, Vec3>> rim;
  for (const auto& [edge, count] : uses) {
    if (count == 1) rim.push_back(ends[edge]);
  }
  return rim;
}

constexpr int kSteps = 4;  // along an edge

}  // namespace

double distance_to(const Mesh& from, const Mesh& to) {
  std::vector<std::pair<Vec3, Vec3>> boxes;  // of the faces, to pass over what lies further away
  for (const auto& [a, b, c] : to.triangles) {
    const Vec3& p = to.positions[a];
    const Vec3& q = to.positions[b];
    const Vec3& r = to.positions[c];
    boxes.emplace_back(p.cwiseMin(q).cwiseMin(r), p.cwiseMax(q).cwiseMax(r));
  }
  double largest = 0;
  for (const Triangle& t : from.triangles) {
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; i + j <= kSteps; ++j) {
        const double u = static_cast<double>(i) / kSteps;
        const double v = static_cast<double>(j) / kSteps;
        const Vec3 p = (1 - u - v) * from.positions[t[0]] + u * from.positions[t[1]] +
                       v * from.positions[t[2]];
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t f = 0; f < boxes.size() && least > largest; ++f) {
          const auto& [lo, hi] = boxes[f];
          if ((lo - p).cwiseMax(p - hi).cwiseMax(0).norm() >= least) continue;
          const auto& [a, b, c] = to.triangles[f];
          least = std::min(
              least, distance_to_triangle(p, to.positions[a], to.positions[b], to.positions[c]));
        }
        largest = std::max(largest, least);
      }
    }
  }
  return largest;
}

double rim_distance_to(const Mesh& from, const Mesh& to) {
  const auto target = rim_of(to);
  double largest = 0;
  for (const auto& [a, b] : rim_of(from)) {
    for (int i = 0; i <= kSteps; ++i) {
      const Vec3 p = a + static_cast<double>(i) / kSteps * (b - a);
      double least = std::numeric_limits<double>::infinity();
      for (const auto& [c, d] : target) least = std::min(least, distance_to_segment(p, c, d));
      largest = std::max(largest, least);
    }
  }
  return largest;
}

}  // namespace kdm::check
