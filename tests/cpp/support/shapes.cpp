// SPDX-License-Identifier: MIT
#include "shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <stdexcept>

namespace kdm::shapes {
namespace {

Vec3 rotate(const Vec3& p, const Vec3& axis, double angle) {
  const double c = cosine(angle);
  const double s = sine(angle);
  return p * c + axis.cross(p) * s + axis * (axis.dot(p) * (1 - c));
}

// Uniform in [0, 1) from the generator's top bits: std::uniform_real_distribution differs between
// standard libraries.
double unit_random(std::mt19937& engine) { return static_cast<double>(engine()) / 4294967296.0; }

}  // namespace

double sine(double angle) { return cosine(angle - std::numbers::pi / 2); }

double cosine(double angle) {
  const double turns = angle / (2 * std::numbers::pi);
  const double x = std::abs(turns - std::floor(turns + 0.5)) * 2 * std::numbers::pi;  // 0 to pi
  if (x == 0) return 1;
  // cos x = 2 cos^2(x/2) - 1, twice, around the power series at x/4 <= pi/4.
  const double q = x * x / 16;
  double sum = 0;
  for (int k = 9; k > 0; --k) sum = (1 + sum) * -q / ((2.0 * k - 1) * (2.0 * k));
  double c = 1 + sum;
  c = 2 * c * c - 1;
  c = 2 * c * c - 1;
  return std::abs(c) < 1e-15 ? 0 : c;
}

Mesh merged(const std::vector<Mesh>& parts) {
  Mesh out;
  for (const Mesh& part : parts) {
    const Index base = static_cast<Index>(out.positions.size());
    out.positions.insert(out.positions.end(), part.positions.begin(), part.positions.end());
    for (const Triangle& t : part.triangles) {
      out.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
    }
  }
  return out;
}

Mesh translated(Mesh mesh, const Vec3& by) {
  for (Vec3& p : mesh.positions) p += by;
  return mesh;
}

Mesh scaled(Mesh mesh, const Vec3& by) {
  for (Vec3& p : mesh.positions) p = p.cwiseProduct(by);
  return by.prod() < 0 ? inverted(std::move(mesh)) : mesh;
}

Mesh rotated(Mesh mesh, const Vec3& axis, double angle) {
  const Vec3 unit = axis.normalized();
  for (Vec3& p : mesh.positions) p = rotate(p, unit, angle);
  return mesh;
}

Mesh turned(const Mesh& mesh) {
  return rotated(rotated(mesh, Vec3(1, 2, 3), 0.7), Vec3(-2, 1, 1), 1.1);
}

Mesh inverted(Mesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

Mesh subdivided(Mesh mesh) {
  std::map<std::pair<Index, Index>, Index> midpoints;
  const auto midpoint = [&](Index a, Index b) {
    const auto [entry, fresh] = midpoints.try_emplace(std::minmax(a, b), 0);
    if (fresh) {
      entry->second = static_cast<Index>(mesh.positions.size());
      mesh.positions.push_back(0.5 * (mesh.positions[a] + mesh.positions[b]));
    }
    return entry->second;
  };
  std::vector<Triangle> fine;
  fine.reserve(mesh.triangles.size() * 4);
  for (const auto& [a, b, c] : mesh.triangles) {
    const Index ab = midpoint(a, b);
    const Index bc = midpoint(b, c);
    const Index ca = midpoint(c, a);
    fine.insert(fine.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  mesh.triangles = std::move(fine);
  return mesh;
}

Mesh jittered(Mesh mesh, double amplitude, std::uint32_t seed) {
  std::mt19937 engine(seed);
  for (Vec3& p : mesh.positions) {
    for (int axis = 0; axis < 3; ++axis) p[axis] += amplitude * (2 * unit_random(engine) - 1);
  }
  return mesh;
}

Mesh snapped(Mesh mesh, double step) {
  for (Vec3& p : mesh.positions) {
    for (int axis = 0; axis < 3; ++axis) p[axis] = std::floor(p[axis] / step + 0.5) * step;
  }
  return mesh;
}

Mesh soup(const Mesh& mesh) {
  Mesh out;
  for (const Triangle& t : mesh.triangles) {
    const Index base = static_cast<Index>(out.positions.size());
    for (const Index v : t) out.positions.push_back(mesh.positions[v]);
    out.triangles.push_back({base, base + 1, base + 2});
  }
  return out;
}

Mesh open(Mesh mesh, Index missing_faces) {
  mesh.triangles.resize(mesh.triangles.size() - missing_faces);
  return mesh;
}

double signed_volume(const Mesh& mesh) {
  double six_volumes = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    six_volumes += mesh.positions[a].dot(mesh.positions[b].cross(mesh.positions[c]));
  }
  return six_volumes / 6;
}

Mesh box(const Vec3& min, const Vec3& max) {
  Mesh mesh;
  //     6-----7        corner number = x + 2 y + 4 z
  //    /|    /|
  //   4-----5 |
  //   | 2---|-3
  //   0-----1
  for (int corner = 0; corner < 8; ++corner) {
    mesh.positions.emplace_back(corner & 1 ? max.x() : min.x(), corner & 2 ? max.y() : min.y(),
                                corner & 4 ? max.z() : min.z());
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

Mesh cube() { return box(Vec3::Zero(), Vec3::Ones()); }

Mesh tetrahedron() {
  return tetrahedron(Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1));
}

Mesh tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  Mesh mesh;
  mesh.positions = {a, b, c, d};
  mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  return signed_volume(mesh) < 0 ? inverted(std::move(mesh)) : mesh;
}

Mesh icosphere(int subdivisions, double radius) {
  Mesh mesh;
  const double g = (1 + std::sqrt(5.0)) / 2;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      for (const double other : {g, -g}) {
        Vec3 p = Vec3::Zero();
        p[axis] = sign;
        p[(axis + 1) % 3] = other;
        mesh.positions.push_back(p);
      }
    }
  }
  // The faces are the triples of vertices at mutual distance 2.
  const auto adjacent = [&](Index a, Index b) {
    return std::abs((mesh.positions[a] - mesh.positions[b]).norm() - 2) < 1e-6;
  };
  for (Index a = 0; a < 12; ++a) {
    for (Index b = a + 1; b < 12; ++b) {
      for (Index c = b + 1; c < 12; ++c) {
        if (!adjacent(a, b) || !adjacent(b, c) || !adjacent(a, c)) continue;
        const Vec3 normal =
            (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
        const bool outward = normal.dot(mesh.positions[a]) > 0;
        mesh.triangles.push_back(outward ? Triangle{a, b, c} : Triangle{a, c, b});
      }
    }
  }
  for (int i = 0; i < subdivisions; ++i) mesh = subdivided(std::move(mesh));
  for (Vec3& p : mesh.positions) p *= radius / p.norm();
  return mesh;
}

Mesh uv_sphere(int segments, int rings, double radius) {
  std::vector<std::pair<double, double>> profile;
  for (int i = 0; i <= rings; ++i) {
    const double angle = std::numbers::pi * i / rings;
    const bool pole = i == 0 || i == rings;
    profile.emplace_back(pole ? 0 : radius * sine(angle), radius * cosine(angle));
  }
  return revolved(profile, segments);
}

Mesh cylinder(double radius, double height, int segments) {
  return revolved({{0, 0}, {radius, 0}, {radius, height}, {0, height}}, segments);
}

Mesh revolved(const std::vector<std::pair<double, double>>& profile, int segments) {
  Mesh mesh;
  const Index count = static_cast<Index>(profile.size());
  const Index around = static_cast<Index>(segments);
  std::vector<Index> first(count);
  for (Index i = 0; i < count; ++i) {
    const auto [r, z] = profile[i];
    first[i] = static_cast<Index>(mesh.positions.size());
    for (Index k = 0; k < (r == 0 ? 1 : around); ++k) {
      const double angle = 2 * std::numbers::pi * k / around;
      mesh.positions.emplace_back(r * cosine(angle), r * sine(angle), z);
    }
  }
  const auto vertex = [&](Index i, Index k) {
    return first[i] + (profile[i].first == 0 ? 0 : k % around);
  };
  for (Index i = 0; i < count; ++i) {
    const Index j = (i + 1) % count;
    if (profile[i].first == 0 && profile[j].first == 0) continue;  // the axis is no surface
    for (Index k = 0; k < around; ++k) {
      const Triangle lower{vertex(i, k), vertex(i, k + 1), vertex(j, k + 1)};
      const Triangle upper{vertex(i, k), vertex(j, k + 1), vertex(j, k)};
      if (profile[i].first != 0) mesh.triangles.push_back(lower);
      if (profile[j].first != 0) mesh.triangles.push_back(upper);
    }
  }
  return signed_volume(mesh) < 0 ? inverted(std::move(mesh)) : mesh;
}

Mesh torus(double major, double minor, int major_segments, int minor_segments) {
  std::vector<std::pair<double, double>> profile;
  for (int i = 0; i < minor_segments; ++i) {
    const double angle = 2 * std::numbers::pi * i / minor_segments;
    profile.emplace_back(major + minor * cosine(angle), minor * sine(angle));
  }
  return revolved(profile, major_segments);
}

Mesh voxels(int nx, int ny, int nz, const std::function<bool(int, int, int)>& filled) {
  const auto solid = [&](int x, int y, int z) {
    return x >= 0 && y >= 0 && z >= 0 && x < nx && y < ny && z < nz && filled(x, y, z);
  };
  Mesh mesh;
  std::map<std::array<int, 3>, Index> numbers;
  const auto vertex = [&](const std::array<int, 3>& p) {
    const auto [entry, fresh] = numbers.try_emplace(p, static_cast<Index>(mesh.positions.size()));
    if (fresh) mesh.positions.emplace_back(p[0], p[1], p[2]);
    return entry->second;
  };
  for (int z = 0; z < nz; ++z) {
    for (int y = 0; y < ny; ++y) {
      for (int x = 0; x < nx; ++x) {
        if (!solid(x, y, z)) continue;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          for (const int side : {0, 1}) {
            std::array<int, 3> neighbour{x, y, z};
            neighbour[axis] += side == 1 ? 1 : -1;
            if (solid(neighbour[0], neighbour[1], neighbour[2])) continue;
            std::array<int, 3> a{x, y, z};
            a[axis] += side;
            std::array<int, 3> b = a;
            ++b[(axis + 1) % 3];
            std::array<int, 3> c = b;
            ++c[(axis + 2) % 3];
            std::array<int, 3> d = a;
            ++d[(axis + 2) % 3];
            if (side == 0) std::swap(b, d);
            mesh.triangles.push_back({vertex(a), vertex(b), vertex(c)});
            mesh.triangles.push_back({vertex(a), vertex(c), vertex(d)});
          }
        }
      }
    }
  }
  return mesh;
}

}  // namespace kdm::shapes
