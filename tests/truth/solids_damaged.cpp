// SPDX-License-Identifier: MIT
// Kinds that are good solids once they are repaired: doubled, open, torn; and sound ones.
#include <algorithm>
#include <set>

#include "truth/parts.h"

namespace kdm::truth {
namespace {

Solid good_solid(Random& random, const Cells& cells) {
  Solid solid;
  solid.input = boundary_of(cells, random);
  solid.account = account_of(cells, random);
  return solid;
}

Vec3 size_of(const Cells& cells) {
  return cells.corner({cells.count(0), cells.count(1), cells.count(2)}) - cells.corner({0, 0, 0});
}

// A few squares in a plane: they enclose nothing, and the account is that of nothing.
Solid flat_sheet(Random& random) {
  Cells cells(even_lines(4));
  Block block = random_block(random, cells);
  block.from[2] = 0;
  block.to[2] = 1;
  cells.fill(block);
  Solid solid = good_solid(random, cells);
  Mesh& mesh = solid.input;
  const auto leaves_plane = [&](const Triangle& t) {
    for (const Index v : t) {
      if (mesh.positions[v].z() != 0) return true;
    }
    return false;
  };
  std::erase_if(mesh.triangles, leaves_plane);
  solid.account = Account{};
  solid.variant = "sheet";
  solid.tolerance = 0.01;
  return solid;
}

double share_of_size(Random& random, const Cells& cells) {
  constexpr std::array<double, 4> kShares = {0.001, 0.002, 0.005, 0.01};
  return size_of(cells).norm() * kShares[random.below(4)];
}

}  // namespace

// The control: what the other kinds here are before they are damaged.
Solid make_sound(Random& random) {
  const Cells cells = random_lump(random);
  Solid solid = good_solid(random, cells);
  solid.variant = "lump";
  solid.tolerance = share_of_size(random, cells);
  return solid;
}

Solid make_doubled(Random& random) {
  if (random.below(8) == 0) {
    Solid sheet = flat_sheet(random);
    append(sheet.input, turned_over(sheet.input));
    return sheet;
  }
  const Cells cells = random_lump(random);
  Solid solid = good_solid(random, cells);
  solid.tolerance = share_of_size(random, cells);
  if (random.coin()) {
    solid.variant = "shared";
    Mesh& mesh = solid.input;
    const std::size_t count = mesh.triangles.size();
    for (std::size_t t = 0; t < count; ++t) {
      const auto [a, b, c] = mesh.triangles[t];
      mesh.triangles.push_back({a, c, b});
    }
  } else {
    solid.variant = "copied";
    append(solid.input, turned_over(solid.input));
  }
  return solid;
}

// Squares are left out, all of a hole in one plane, a seventh of all at most.
Solid make_open(Random& random) {
  if (random.below(8) == 0) return flat_sheet(random);
  const Cells cells = random_lump(random);
  Solid solid = good_solid(random, cells);
  solid.tolerance = share_of_size(random, cells);
  Mesh& mesh = solid.input;
  const std::size_t squares = mesh.triangles.size() / 2;
  const auto corners = [&](std::size_t square) {
    const Triangle& s = mesh.triangles[2 * square];
    const Triangle& t = mesh.triangles[2 * square + 1];
    std::set<Index> all(s.begin(), s.end());
    all.insert(t.begin(), t.end());
    return all;
  };
  const bool several = random.coin();
  solid.variant = several ? "squares" : "one-square";
  std::set<std::size_t> missing;
  std::set<Index> at_holes;
  const std::size_t most = several ? std::max<std::size_t>(1, squares / 14) : 1;
  for (std::size_t tries = 0; tries < 4 * most && missing.size() < most; ++tries) {
    const std::size_t square = random.below(static_cast<std::uint32_t>(squares));
    const std::set<Index> own = corners(square);
    if (missing.contains(square)) continue;
    if (std::any_of(own.begin(), own.end(), [&](Index v) { return at_holes.contains(v); })) {
      continue;
    }
    missing.insert(square);
    at_holes.insert(own.begin(), own.end());
  }
  std::vector<Triangle> left;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!missing.contains(t / 2)) left.push_back(mesh.triangles[t]);
  }
  mesh.triangles = left;
  return solid;
}

Solid make_torn(Random& random) {
  const Cells cells = random_lump(random);
  Solid solid = good_solid(random, cells);
  solid.tolerance = share_of_size(random, cells);
  solid.input = taken_apart(solid.input);
  const bool whole = random.coin();
  solid.variant = whole ? "facets" : "corners";
  // Corners that were one are at most 0.9 of the tolerance apart.
  solid.slack = solid.tolerance * spread(random, -6, -2) * 0.9;
  Vec3 by = Vec3::Zero();
  for (std::size_t v = 0; v < solid.input.positions.size(); ++v) {
    if (!whole || v % 3 == 0) {
      by = random.direction();
      by *= solid.slack * random.unit();
    }
    solid.input.positions[v] += by;
  }
  return solid;
}

}  // namespace kdm::truth
