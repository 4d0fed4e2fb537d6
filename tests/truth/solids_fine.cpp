// SPDX-License-Identifier: MIT
// Kinds with parts that are finer than the tolerance, or that are round: thin, wire, spun.
#include <algorithm>

#include "support/shapes.h"
#include "truth/parts.h"

namespace kdm::truth {
namespace {

constexpr double kTwoPi = 6.283185307179586;

// Sine and cosine of the i-th part of a turn.
struct Turn {
  int segments;
  double cosine(int i) const { return shapes::cosine(kTwoPi * i / segments); }
  double sine(int i) const { return shapes::sine(kTwoPi * i / segments); }
};

// Rings of points one after the other, joined by strips; a ring of radius 0 is one vertex.
struct Rings {
  Mesh mesh;
  std::vector<std::vector<Index>> rings;

  void add(const std::vector<Vec3>& points) {
    std::vector<Index> ring;
    for (const Vec3& p : points) {
      ring.push_back(static_cast<Index>(mesh.positions.size()));
      mesh.positions.push_back(p);
    }
    rings.push_back(ring);
  }
  void join(std::size_t lower, std::size_t upper) {
    const auto& a = rings[lower];
    const auto& b = rings[upper];
    const std::size_t n = std::max(a.size(), b.size());
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      const auto at = [](const std::vector<Index>& ring, std::size_t k) {
        return ring[ring.size() == 1 ? 0 : k];
      };
      if (a.size() > 1) mesh.triangles.push_back({at(a, i), at(a, j), at(b, j)});
      if (b.size() > 1) mesh.triangles.push_back({at(a, i), at(b, j), at(b, i)});
    }
  }
  void cap(std::size_t ring, bool up) {
    const auto& r = rings[ring];
    for (std::size_t i = 1; i + 1 < r.size(); ++i) {
      mesh.triangles.push_back({r[0], r[up ? i : i + 1], r[up ? i + 1 : i]});
    }
  }
};

// Lines with some layers that are far thinner than others, measured in tolerances.
Lines lines_with_thin_layers(Random& random, double tolerance) {
  Lines lines;
  for (auto& axis : lines) {
    axis.push_back(0);
    for (int i = number(random, 1, 4); i >= 0; --i) {
      const bool thin = random.below(5) < 2;
      axis.push_back(axis.back() +
                     (thin ? tolerance * spread(random, -6, 2) : random.between(0.5, 2)));
    }
  }
  return lines;
}

}  // namespace

Solid make_thin(Random& random) {
  constexpr std::array<double, 3> kTolerances = {0.004, 0.01, 0.03};
  const double tolerance = kTolerances[random.below(3)];
  const std::uint32_t variant = random.below(4);
  if (variant == 0) {
    // A plate, or a rod.
    Lines lines = {{{0, random.between(0.5, 3)},
                    {0, random.between(0.5, 3)},
                    {0, tolerance * spread(random, -6, 2)}}};
    const bool rod = random.coin();
    if (rod) lines[1][1] = tolerance * spread(random, -6, 2);
    std::rotate(lines.begin(), lines.begin() + number(random, 0, 2), lines.end());
    Cells cells(lines);
    cells.fill({{0, 0, 0}, {1, 1, 1}});
    return solid_of(rod ? "rod" : "plate", boundary_of(cells, random), cells, tolerance, random);
  }
  if (variant == 1) {
    // A gap between two blocks, or walls round a cavity.
    const double width = tolerance * spread(random, -6, 2);
    Lines lines;
    const bool walls = random.coin();
    for (auto& axis : lines) {
      if (walls)
        axis = {0, width, width + random.between(0.5, 2)};
      else
        axis = {0, random.between(0.5, 2)};
      axis.push_back(axis.back() + width);
      if (!walls) axis.push_back(axis.back() + random.between(0.5, 2));
    }
    Cells cells(lines);
    if (walls) {
      cells.fill({{0, 0, 0}, {3, 3, 3}});
      cells.fill({{1, 1, 1}, {2, 2, 2}}, false);
    } else {
      cells.fill({{0, 0, 0}, {1, 3, 3}});
      cells.fill({{2, 0, 0}, {3, 3, 3}});
    }
    return solid_of(walls ? "walls" : "gap", boundary_of(cells, random), cells, tolerance, random);
  }
  const Lines lines = lines_with_thin_layers(random, tolerance);
  Cells cells(lines);
  Mesh mesh;
  std::vector<Block> drawn;
  for (int blocks = number(random, 1, 4); blocks > 0; --blocks) {
    const Block block = random_block(random, cells);
    cells.fill(block);
    drawn.push_back(block);
    append(mesh, block_surface(cells, block, random));
  }
  if (variant == 2) {
    Solid solid = solid_of("blocks", mesh, cells, tolerance, random);
    solid.apart = topologies_apart(lines, drawn);
    return solid;
  }
  return solid_of("merged", boundary_of(cells, random), cells, tolerance, random);
}

Solid make_wire(Random& random) {
  const double tolerance = 0.01;
  const double width = tolerance * spread(random, -5, 5);
  if (random.coin()) {
    // A tube along lines of a lattice, with branches and rounds where it meets itself.
    const int n = number(random, 1, 3);
    Lines lines;
    for (auto& axis : lines) {
      for (int i = 0; i <= n; ++i) {
        axis.push_back(i);
        axis.push_back(i + width);
      }
    }
    Cells cells(lines);
    Place at = {0, 0, 0};
    for (int steps = number(random, 1, 4 + 4 * n); steps > 0; --steps) {
      const int axis = number(random, 0, 2);
      Place next = at;
      next[axis] += random.coin() ? 2 : -2;
      if (next[axis] < 0 || next[axis] > 2 * n) {
        ++steps;
        continue;
      }
      const Place from = {std::min(at[0], next[0]), std::min(at[1], next[1]),
                          std::min(at[2], next[2])};
      Place to = {std::max(at[0], next[0]) + 1, std::max(at[1], next[1]) + 1,
                  std::max(at[2], next[2]) + 1};
      cells.fill({from, to});
      at = next;
    }
    return solid_of("lattice", boundary_of(cells, random), cells, tolerance, random);
  }
  // A tube that runs on in z, its rings level: it cannot meet itself.
  Solid solid;
  solid.variant = "tube";
  const Turn turn{number(random, 3, 8)};
  Rings tube;
  Vec3 at = Vec3::Zero();
  const int rings = number(random, 2, 6);
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<Vec3> points;
    for (int i = 0; i < turn.segments; ++i) {
      points.push_back(at + Vec3(turn.cosine(i), turn.sine(i), 0) * (width / 2));
    }
    tube.add(points);
    const double x = random.between(-1, 1);
    const double y = random.between(-1, 1);
    at += Vec3(x, y, random.between(0.5, 1.5));
  }
  for (std::size_t ring = 1; ring < tube.rings.size(); ++ring) tube.join(ring - 1, ring);
  tube.cap(0, false);
  tube.cap(tube.rings.size() - 1, true);
  solid.input = solid.account.boundary = tube.mesh;
  solid.account.volume = volume_of(tube.mesh);
  solid.account.topology.any_of = {{1, 2}};
  solid.tolerance = tolerance;
  return solid;
}

Solid make_spun(Random& random) {
  Solid solid;
  solid.tolerance = random.coin() ? 0.004 : 0.02;
  const Turn turn{number(random, 3, 12)};
  const auto ring = [&](double radius, double z) {
    std::vector<Vec3> points;
    if (radius == 0) return std::vector<Vec3>{Vec3(0, 0, z)};
    for (int i = 0; i < turn.segments; ++i) {
      points.push_back(Vec3(turn.cosine(i) * radius, turn.sine(i) * radius, z));
    }
    return points;
  };
  Rings spun;
  if (random.below(3) == 0) {
    // A ring that touches the axis in one vertex: two cones of void meet there in the solid.
    solid.variant = "ring";
    const double outer = random.between(0.5, 2);
    spun.add(ring(0, random.between(-0.2, 0.2)));
    spun.add(ring(outer, -random.between(0.4, 1)));
    const double widest = outer * random.between(0.8, 1.5);
    spun.add(ring(widest, random.between(-0.2, 0.2)));
    const double upper = outer * random.between(0.6, 1);
    spun.add(ring(upper, random.between(0.4, 1)));
    for (std::size_t i = 0; i < 4; ++i) spun.join(i, (i + 1) % 4);
    solid.account.topology.any_of = {{1, 0}, {1, 2}};
    solid.account.contacts = 1;
  } else {
    // Beads along the axis, which touch where the profile does.
    solid.variant = "beads";
    const int rings = number(random, 3, 7);
    int beads = 1;
    double z = 0;
    bool last_zero = false;
    for (int i = 0; i < rings; ++i) {
      const bool end = i == 0 || i == rings - 1;
      const bool touch = end ? random.coin() : !last_zero && i < rings - 2 && random.below(3) == 0;
      spun.add(ring(touch ? 0 : random.between(0.3, 1), z));
      beads += touch && !end ? 1 : 0;
      last_zero = touch;
      z += random.between(0.3, 1);
    }
    for (std::size_t i = 1; i < spun.rings.size(); ++i) spun.join(i - 1, i);
    if (spun.rings.front().size() > 1) spun.cap(0, false);
    if (spun.rings.back().size() > 1) spun.cap(spun.rings.size() - 1, true);
    for (int parts = 1; parts <= beads; ++parts) {
      solid.account.topology.any_of.insert({parts, 2 * parts});
    }
    solid.account.contacts = beads - 1;
  }
  solid.input = solid.account.boundary = spun.mesh;
  solid.account.volume = volume_of(spun.mesh);
  return solid;
}

}  // namespace kdm::truth
