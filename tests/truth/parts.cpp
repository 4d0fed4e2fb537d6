// SPDX-License-Identifier: MIT
#include "truth/parts.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace kdm::truth {

int number(Random& random, int from, int to) {
  return from + static_cast<int>(random.below(static_cast<std::uint32_t>(to - from + 1)));
}

double spread(Random& random, int from_power, int to_power) {
  const int power = number(random, from_power, to_power - 1);
  return std::ldexp(1 + random.unit(), power);
}

Lines even_lines(int n) {
  Lines lines;
  for (auto& axis : lines) {
    for (int i = 0; i <= n; ++i) axis.push_back(i);
  }
  return lines;
}

Lines uneven_lines(Random& random, int n) {
  Lines lines;
  for (auto& axis : lines) {
    axis.push_back(0);
    for (int i = 0; i < n; ++i) axis.push_back(axis.back() + random.between(0.4, 1.6));
  }
  return lines;
}

Block random_block(Random& random, const Cells& cells, int least) {
  Block block;
  for (int axis = 0; axis < 3; ++axis) {
    const int size = number(random, least, std::max(least, cells.count(axis) - 1));
    block.from[axis] = number(random, 0, cells.count(axis) - size);
    block.to[axis] = block.from[axis] + size;
  }
  return block;
}

void append(Mesh& mesh, Mesh part) {
  const Index first = static_cast<Index>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
  for (const auto& [a, b, c] : part.triangles) {
    mesh.triangles.push_back({first + a, first + b, first + c});
  }
}

Solid solid_of(std::string variant, Mesh input, const Cells& cells, double tolerance,
               Random& random) {
  Solid solid;
  solid.variant = std::move(variant);
  solid.input = std::move(input);
  solid.account = account_of(cells, random);
  solid.tolerance = tolerance;
  return solid;
}

Mesh turned_over(Mesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

Mesh taken_apart(const Mesh& mesh) {
  Mesh apart;
  for (const Triangle& t : mesh.triangles) {
    const Index first = static_cast<Index>(apart.positions.size());
    for (const Index v : t) apart.positions.push_back(mesh.positions[v]);
    apart.triangles.push_back({first, first + 1, first + 2});
  }
  return apart;
}

Cells random_lump(Random& random) {
  for (;;) {
    Cells cells(random.coin() ? even_lines(5) : uneven_lines(random, 5));
    for (int blocks = number(random, 1, 3); blocks > 0; --blocks) {
      cells.fill(random_block(random, cells, 2));
    }
    Random diagonals(1);
    const Account account = account_of(cells, diagonals);
    if (account.contacts == 0 && account.topology.any_of.begin()->first == 1) return cells;
  }
}

std::set<Topology> topologies_apart(const Lines& lines, const std::vector<Block>& blocks) {
  constexpr std::size_t kMostTouching = 6;
  std::vector<std::pair<std::size_t, std::size_t>> crossing;
  std::vector<std::pair<std::size_t, std::size_t>> touching;
  for (std::size_t a = 0; a < blocks.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (overlap(blocks[a], blocks[b])) {
        crossing.push_back({a, b});
      } else if (meet(blocks[a], blocks[b])) {
        touching.push_back({a, b});
      }
    }
  }
  std::set<Topology> found;
  const std::size_t tried = touching.size() > kMostTouching ? 0 : touching.size();
  for (unsigned joined = 0; joined < 1u << tried; ++joined) {
    std::vector<std::size_t> group(blocks.size());
    std::iota(group.begin(), group.end(), std::size_t{0});
    const auto join = [&](const std::pair<std::size_t, std::size_t>& pair) {
      const std::size_t from = group[pair.first];
      std::replace(group.begin(), group.end(), from, group[pair.second]);
    };
    std::for_each(crossing.begin(), crossing.end(), join);
    for (std::size_t i = 0; i < tried; ++i) {
      if ((joined >> i & 1) != 0) join(touching[i]);
    }
    std::set<Topology> sums = {{0, 0}};
    for (std::size_t g = 0; g < blocks.size(); ++g) {
      Cells cells(lines);
      for (std::size_t b = 0; b < blocks.size(); ++b) {
        if (group[b] == g) cells.fill(blocks[b]);
      }
      Random diagonals(1);
      if (cells.volume() == 0) continue;
      std::set<Topology> next;
      for (const Topology& own : account_of(cells, diagonals).topology.any_of) {
        for (const Topology& sum : sums) {
          next.insert({sum.first + own.first, sum.second + own.second});
        }
      }
      sums = next;
    }
    found.insert(sums.begin(), sums.end());
  }
  return found;
}

double draw_tolerance(Random& random, const Lines& lines) {
  const Vec3 size(lines[0].back() - lines[0].front(), lines[1].back() - lines[1].front(),
                  lines[2].back() - lines[2].front());
  constexpr std::array<double, 4> kShares = {0.001, 0.002, 0.005, 0.01};
  return size.norm() * kShares[random.below(4)];
}

}  // namespace kdm::truth
