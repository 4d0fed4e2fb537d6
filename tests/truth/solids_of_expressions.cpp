// SPDX-License-Identifier: MIT
// Boolean expressions over prisms whose sides lie in few planes, so that many of them coincide.
#include <algorithm>
#include <utility>

#include "truth/parts.h"

namespace kdm::truth {
namespace {

// One block, or two of the same height that overlap or have a side in common.
struct Prism {
  std::vector<Block> blocks;

  bool holds(const Place& cell) const {
    const Block here = {cell, {cell[0] + 1, cell[1] + 1, cell[2] + 1}};
    return std::any_of(blocks.begin(), blocks.end(),
                       [&](const Block& block) { return overlap(block, here); });
  }
};

Prism random_prism(Random& random, const Cells& cells) {
  for (;;) {
    Prism prism{{random_block(random, cells)}};
    if (random.coin()) return prism;
    Block second = random_block(random, cells);
    second.from[2] = prism.blocks[0].from[2];
    second.to[2] = prism.blocks[0].to[2];
    prism.blocks.push_back(second);
    Cells filled = cells;
    for (const Block& block : prism.blocks) filled.fill(block);
    Random diagonals(1);
    const Account account = account_of(filled, diagonals);
    if (account.contacts == 0 && account.topology.any_of.begin()->first == 1) return prism;
  }
}

Mesh surface_of(const Prism& prism, Cells cells, bool whole_sides, Random& random) {
  if (prism.blocks.size() == 1 && whole_sides) return block_surface(cells, prism.blocks[0], random);
  for (const Block& block : prism.blocks) cells.fill(block);
  return boundary_of(cells, random);
}

Expression join(const Expression& a, const Expression& b, Random& random) {
  switch (random.below(5)) {
    case 0:
      return union_of(a, b);
    case 1:
      return intersection(a, b);
    case 2:
      return difference(a, b);
    case 3:
      return intersection(a, complement(b));
    default:
      return symmetric_difference(a, b);
  }
}

// Every operand from `first` up to, but without, `last` occurs, and maybe another one once more.
Expression random_expression(Random& random, Index first, Index last) {
  if (last - first == 1) {
    if (first == 0 || random.below(6) > 0) return first;
    return join(first, random.below(first), random);
  }
  const Index middle = first + 1 + random.below(last - first - 1);
  const Expression low = random_expression(random, first, middle);
  const Expression high = random_expression(random, middle, last);
  return random.coin() ? join(low, high, random) : join(high, low, random);
}

bool value_of(const Expression& expression, const std::vector<Prism>& prisms, const Place& cell) {
  std::vector<bool> values;
  for (const auto& [kind, first, second] : expression.nodes()) {
    switch (kind) {
      case Expression::Kind::kOperand:
        values.push_back(prisms[first].holds(cell));
        break;
      case Expression::Kind::kUnion:
        values.push_back(values[first] || values[second]);
        break;
      case Expression::Kind::kIntersection:
        values.push_back(values[first] && values[second]);
        break;
      case Expression::Kind::kExclusive:
        values.push_back(values[first] != values[second]);
        break;
      case Expression::Kind::kComplement:
        values.push_back(!values[first]);
    }
  }
  return values.back();
}

// Moves the lines along z a little to the side, each its own way: all sides stay flat.
class Bend {
 public:
  Bend(Random& random, int n) : n_(n) {
    for (int i = 0; i < (n + 1) * (n + 1); ++i) {
      const double x = random.between(-0.25, 0.25);
      const double y = random.between(-0.25, 0.25);
      by_.push_back(Vec3(x, y, 0));
    }
  }
  void apply(Mesh& mesh) const {
    for (Vec3& p : mesh.positions) {
      p += by_[static_cast<std::size_t>(p.x()) * (n_ + 1) + static_cast<std::size_t>(p.y())];
    }
  }

 private:
  std::size_t n_;
  std::vector<Vec3> by_;
};

}  // namespace

Solid make_expression(Random& random) {
  const int n = number(random, 3, 5);
  const bool bent = random.below(3) == 0;
  const Lines lines = bent || random.coin() ? even_lines(n) : uneven_lines(random, n);
  const Cells none(lines);
  std::vector<Prism> prisms;
  std::vector<Mesh> operands;
  Mesh input;
  for (int count = number(random, 2, 4); count > 0; --count) {
    prisms.push_back(random_prism(random, none));
    operands.push_back(surface_of(prisms.back(), none, !bent && random.coin(), random));
  }
  const Expression expression = random_expression(random, 0, static_cast<Index>(prisms.size()));
  Cells cells(lines);
  for (int z = 0; z < n; ++z) {
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) {
        cells.fill({{x, y, z}, {x + 1, y + 1, z + 1}}, value_of(expression, prisms, {x, y, z}));
      }
    }
  }
  Solid solid =
      solid_of(bent ? "bent" : "straight", {}, cells, draw_tolerance(random, lines), random);
  if (bent) {
    const Bend bend(random, n);
    std::for_each(operands.begin(), operands.end(), [&](Mesh& mesh) { bend.apply(mesh); });
    bend.apply(solid.account.boundary);
    solid.account.volume = volume_of(solid.account.boundary);
  }
  for (const Mesh& operand : operands) append(solid.input, operand);
  solid.operands = std::move(operands);
  solid.expression = expression;
  return solid;
}

}  // namespace kdm::truth
