// SPDX-License-Identifier: MIT
#include "truth/cells.h"

#include <map>
#include <utility>

namespace kdm::truth {
namespace {

// Adds a rectangle at right angles to `axis`, seen counter-clockwise from its upper side if `up`.
template <typename Vertex>
void add_rectangle(Mesh& mesh, int axis, bool up, const Place& low, const Place& high,
                   bool other_diagonal, const Vertex& vertex) {
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  Place b = low;
  b[u] = high[u];
  Place c = b;
  c[v] = high[v];
  Place d = low;
  d[v] = high[v];
  std::array<Index, 4> corners = {vertex(low), vertex(b), vertex(c), vertex(d)};
  if (!up) std::swap(corners[1], corners[3]);
  const std::size_t s = other_diagonal ? 1 : 0;
  mesh.triangles.push_back({corners[s], corners[s + 1], corners[(s + 2) % 4]});
  mesh.triangles.push_back({corners[s], corners[(s + 2) % 4], corners[(s + 3) % 4]});
}

}  // namespace

Cells::Cells(Lines lines) : lines_(std::move(lines)) {
  filled_.assign(static_cast<std::size_t>(count(0)) * count(1) * count(2), 0);
}

std::size_t Cells::number(const Place& cell) const {
  return (static_cast<std::size_t>(cell[2]) * count(1) + cell[1]) * count(0) + cell[0];
}

bool Cells::filled(const Place& cell) const {
  for (int axis = 0; axis < 3; ++axis) {
    if (cell[axis] < 0 || cell[axis] >= count(axis)) return false;
  }
  return filled_[number(cell)] != 0;
}

void Cells::fill(const Block& block, bool value) {
  for (int z = block.from[2]; z < block.to[2]; ++z) {
    for (int y = block.from[1]; y < block.to[1]; ++y) {
      for (int x = block.from[0]; x < block.to[0]; ++x) filled_[number({x, y, z})] = value ? 1 : 0;
    }
  }
}

Vec3 Cells::corner(const Place& at) const {
  return Vec3(lines_[0][at[0]], lines_[1][at[1]], lines_[2][at[2]]);
}

double Cells::volume() const {
  double sum = 0;
  for (int z = 0; z < count(2); ++z) {
    for (int y = 0; y < count(1); ++y) {
      for (int x = 0; x < count(0); ++x) {
        if (!filled({x, y, z})) continue;
        sum += (corner({x + 1, y + 1, z + 1}) - corner({x, y, z})).prod();
      }
    }
  }
  return sum;
}

bool overlap(const Block& a, const Block& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (a.to[axis] <= b.from[axis] || b.to[axis] <= a.from[axis]) return false;
  }
  return true;
}

bool meet(const Block& a, const Block& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (a.to[axis] < b.from[axis] || b.to[axis] < a.from[axis]) return false;
  }
  return true;
}

Mesh boundary_of(const Cells& cells, check::Random& diagonals) {
  Mesh mesh;
  std::map<Place, Index> numbers;
  const auto vertex = [&](const Place& at) {
    const auto found = numbers.try_emplace(at, static_cast<Index>(mesh.positions.size()));
    if (found.second) mesh.positions.push_back(cells.corner(at));
    return found.first->second;
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (int z = 0; z <= cells.count(2); ++z) {
      for (int y = 0; y <= cells.count(1); ++y) {
        for (int x = 0; x <= cells.count(0); ++x) {
          Place below = {x, y, z};
          --below[axis];
          const bool up = cells.filled(below);
          if (up == cells.filled({x, y, z})) continue;
          Place high = {x + 1, y + 1, z + 1};
          high[axis] -= 1;
          add_rectangle(mesh, axis, up, {x, y, z}, high, diagonals.coin(), vertex);
        }
      }
    }
  }
  return mesh;
}

Mesh block_surface(const Cells& cells, const Block& block, check::Random& diagonals) {
  Mesh mesh;
  std::map<Place, Index> numbers;
  const auto vertex = [&](const Place& at) {
    const auto found = numbers.try_emplace(at, static_cast<Index>(mesh.positions.size()));
    if (found.second) mesh.positions.push_back(cells.corner(at));
    return found.first->second;
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool up : {false, true}) {
      Place low = block.from;
      Place high = block.to;
      (up ? low : high)[axis] = (up ? block.to : block.from)[axis];
      add_rectangle(mesh, axis, up, low, high, diagonals.coin(), vertex);
    }
  }
  return mesh;
}

}  // namespace kdm::truth
