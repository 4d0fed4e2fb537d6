// SPDX-License-Identifier: MIT
// Kinds that are made of blocks: touching, coincident, nested, overlapping, inverted, voxels.
#include <algorithm>

#include "truth/parts.h"

namespace kdm::truth {
namespace {

// Blocks in each other. An outward part adds one to what winds round its inside; one that is
// turned inwards takes one off, and is a cavity; where nothing is round it, it is meant to be
// solid, and with it all within is turned over.
struct Nest {
  Cells cells;
  Mesh mesh;
  Random& random;

  void add(const Block& block, bool outward, int winding, bool flipped, int depth) {
    const Mesh surface = block_surface(cells, block, random);
    append(mesh, outward ? surface : turned_over(surface));
    bool up = outward != flipped;
    if (!up && winding == 0) {
      up = true;
      flipped = !flipped;
    }
    winding += up ? 1 : -1;
    cells.fill(block, winding > 0);
    if (depth == 0) return;
    std::vector<Block> within;
    for (int tries = number(random, 1, 3); tries > 0; --tries) {
      Block inner;
      bool fits = true;
      for (int axis = 0; axis < 3; ++axis) {
        const int room = block.to[axis] - block.from[axis] - 2;
        if (room < 1) return;
        const int size = number(random, (room + 1) / 2, room);
        inner.from[axis] = block.from[axis] + 1 + number(random, 0, room - size);
        inner.to[axis] = inner.from[axis] + size;
      }
      for (const Block& other : within) fits = fits && !meet(inner, other);
      if (!fits) continue;
      within.push_back(inner);
      add(inner, random.coin(), winding, flipped, depth - 1);
    }
  }
};

}  // namespace

Solid make_touching(Random& random) {
  for (;;) {
    const int n = number(random, 2, 5);
    const Lines lines = random.below(3) > 0 ? even_lines(n) : uneven_lines(random, n);
    Cells cells(lines);
    std::vector<Block> blocks;
    const int wanted = number(random, 2, 5);
    for (int tries = 0; tries < 60 && static_cast<int>(blocks.size()) < wanted; ++tries) {
      Block block = random_block(random, cells);
      for (int axis = 0; axis < 3; ++axis) {
        // Small enough that several find a place.
        block.to[axis] = std::min(block.to[axis], block.from[axis] + (n + 1) / 2);
      }
      bool apart = true;
      bool meets = blocks.empty();
      for (const Block& other : blocks) {
        apart = apart && !overlap(block, other);
        meets = meets || meet(block, other);
      }
      if (apart && meets) blocks.push_back(block);
    }
    if (blocks.size() < 2) continue;
    Mesh mesh;
    for (const Block& block : blocks) {
      cells.fill(block);
      append(mesh, block_surface(cells, block, random));
    }
    const bool merged = random.below(3) == 0;
    if (merged) mesh = boundary_of(cells, random);
    Solid solid =
        solid_of(merged ? "merged" : "blocks", mesh, cells, draw_tolerance(random, lines), random);
    if (!merged) solid.apart = topologies_apart(lines, blocks);
    return solid;
  }
}

Solid make_coincident(Random& random) {
  const Lines lines = random.coin() ? even_lines(5) : uneven_lines(random, 5);
  Cells cells(lines);
  const double tolerance = draw_tolerance(random, lines);
  Block block = random_block(random, cells, 2);
  block.to[0] = std::min(block.to[0], 4);
  block.from[0] = std::min(block.from[0], block.to[0] - 2);
  cells.fill(block);
  Mesh mesh = block_surface(cells, block, random);
  const std::uint32_t variant = random.below(5);
  if (variant == 0) {
    append(mesh, mesh);
    return solid_of("twice", mesh, cells, tolerance, random);
  }
  if (variant == 1) {
    append(mesh, block_surface(cells, block, random));
    return solid_of("twice-otherwise", mesh, cells, tolerance, random);
  }
  Block beside = block;
  if (variant == 2) {
    // Two rooms with the whole of a wall in common, both of them with it.
    beside.from[0] = block.to[0];
    beside.to[0] = number(random, beside.from[0] + 1, 5);
    append(mesh, block_surface(cells, beside, random));
    cells.fill(beside);
    Solid solid = solid_of("walls", mesh, cells, tolerance, random);
    solid.apart = {{2, 4}};
    return solid;
  }
  if (variant == 3) {
    // One wall within one room: its faces bound nothing.
    const int at = number(random, block.from[0] + 1, block.to[0] - 1);
    Block low = block;
    Block high = block;
    low.to[0] = high.from[0] = at;
    Mesh both = block_surface(cells, low, random);
    Mesh second = block_surface(cells, high, random);
    // The first two triangles of a block are its side at the lower x.
    second.triangles.erase(second.triangles.begin(), second.triangles.begin() + 2);
    append(both, second);
    return solid_of("one-wall", both, cells, tolerance, random);
  }
  // A block that is turned inwards and shares a part of a side with the block round it: a notch.
  Block notch = block;
  notch.from[0] = number(random, block.from[0] + 1, block.to[0] - 1);
  for (const int axis : {1, 2}) {
    if (block.to[axis] - block.from[axis] < 3) continue;
    ++notch.from[axis];
    --notch.to[axis];
  }
  append(mesh, turned_over(block_surface(cells, notch, random)));
  cells.fill(notch, false);
  Solid solid = solid_of("notch", mesh, cells, tolerance, random);
  solid.apart = {{2, 4}};
  return solid;
}

Solid make_nested(Random& random) {
  const int n = number(random, 3, 9);
  const Lines lines = random.coin() ? even_lines(n) : uneven_lines(random, n);
  Nest nest{Cells(lines), {}, random};
  nest.add({{0, 0, 0}, {n, n, n}}, true, 0, false, number(random, 1, 4));
  return solid_of("shells", nest.mesh, nest.cells, draw_tolerance(random, lines), random);
}

Solid make_inverted(Random& random) {
  const int n = number(random, 3, 6);
  const int parts = number(random, 2, 3);
  Lines lines = random.coin() ? even_lines(n) : uneven_lines(random, n);
  const int whole = parts * n + parts - 1;
  lines[0].resize(1);
  for (int i = 0; i < whole; ++i) lines[0].push_back(lines[0].back() + 1);
  Nest nest{Cells(lines), {}, random};
  const int bad = number(random, 0, parts - 1);
  const int good = (bad + 1) % parts;
  for (int part = 0; part < parts; ++part) {
    const int from = part * (n + 1);
    const Block block = {{from, 0, 0}, {from + number(random, 1, n), number(random, 1, n), n}};
    const bool outward = part == bad ? false : part == good || random.coin();
    nest.add(block, outward, 0, false, number(random, 0, 2));
  }
  return solid_of("beside", nest.mesh, nest.cells, draw_tolerance(random, lines), random);
}

Solid make_overlapping(Random& random) {
  const int blocks = number(random, 2, 4);
  const bool general = random.coin();
  // In general position each block has lines of its own, and all have the middle in common.
  const Lines lines = general ? uneven_lines(random, 2 * blocks - 1) : even_lines(5);
  Cells cells(lines);
  std::array<std::vector<int>, 3> low;
  std::array<std::vector<int>, 3> high;
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < blocks; ++i) {
      low[axis].push_back(i);
      high[axis].push_back(blocks + i);
    }
    for (int i = blocks - 1; i > 0; --i) {
      std::swap(low[axis][i], low[axis][number(random, 0, i)]);
      std::swap(high[axis][i], high[axis][number(random, 0, i)]);
    }
  }
  Mesh mesh;
  std::vector<Block> drawn;
  for (int i = 0; i < blocks; ++i) {
    Block block = random_block(random, cells, 2);
    for (int axis = 0; general && axis < 3; ++axis) {
      block.from[axis] = low[axis][i];
      block.to[axis] = high[axis][i];
    }
    append(mesh, block_surface(cells, block, random));
    cells.fill(block);
    drawn.push_back(block);
  }
  const double tolerance = draw_tolerance(random, lines);
  Solid solid = solid_of(general ? "general" : "integer", mesh, cells, tolerance, random);
  solid.apart = topologies_apart(lines, drawn);
  return solid;
}

Solid make_voxels(Random& random) {
  const int n = number(random, 3, 4);
  const Lines lines = even_lines(n);
  Cells cells(lines);
  const std::uint32_t share = static_cast<std::uint32_t>(number(random, 2, 8));
  Mesh all;
  for (int z = 0; z < n; ++z) {
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) {
        if (random.below(10) >= share && !(x == 1 && y == 1 && z == 1)) continue;
        const Block voxel = {{x, y, z}, {x + 1, y + 1, z + 1}};
        cells.fill(voxel);
        append(all, block_surface(cells, voxel, random));
      }
    }
  }
  const bool merged = random.coin();
  const Mesh mesh = merged ? boundary_of(cells, random) : all;
  const double tolerance = draw_tolerance(random, lines);
  return solid_of(merged ? "merged" : "all-sides", mesh, cells, tolerance, random);
}

}  // namespace kdm::truth
