// SPDX-License-Identifier: MIT
// Solids made of the cells between lines parallel to the axes: what the truth harness builds its
// inputs from, and what its exact account is computed on. Shares no code with the library.
#pragma once

#include <array>
#include <vector>

#include "kdmanifold/mesh.h"
#include "support/random.h"

namespace kdm::truth {

/// Three numbers of lines or cells, along x, y and z.
using Place = std::array<int, 3>;

/// The cells from `from` up to, but without, `to`.
struct Block {
  Place from;
  Place to;
};

/// The coordinates of the lines along each axis, ascending.
using Lines = std::array<std::vector<double>, 3>;

/// Cells between lines, each filled or not.
class Cells {
 public:
  explicit Cells(Lines lines);

  int count(int axis) const { return static_cast<int>(lines_[axis].size()) - 1; }
  /// What lies outside of all lines is not filled.
  bool filled(const Place& cell) const;
  void fill(const Block& block, bool value = true);
  /// The point where three lines meet.
  Vec3 corner(const Place& at) const;
  double volume() const;

 private:
  std::size_t number(const Place& cell) const;

  Lines lines_;
  std::vector<char> filled_;
};

/// Tells whether two blocks have a cell in common; whether they have a point in common.
bool overlap(const Block& a, const Block& b);
bool meet(const Block& a, const Block& b);

/// The sides of the filled cells beyond which nothing is filled, two triangles each, turned
/// outwards. Vertices have the numbers of their places, so four faces may share an edge.
Mesh boundary_of(const Cells& cells, check::Random& diagonals);

/// The twelve triangles round a block, on vertices of their own, turned outwards.
Mesh block_surface(const Cells& cells, const Block& block, check::Random& diagonals);

}  // namespace kdm::truth
