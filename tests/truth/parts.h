// SPDX-License-Identifier: MIT
// What the kinds of solids are put together from.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "support/random.h"
#include "truth/cells.h"
#include "truth/solid.h"

namespace kdm::truth {

using check::Random;

/// A whole number from `from` to `to`.
int number(Random& random, int from, int to);
/// A number whose logarithm is spread about evenly between two powers of two.
double spread(Random& random, int from_power, int to_power);

/// Lines at 0 to n along each axis; at uneven distances between 0.4 and 1.6.
Lines even_lines(int n);
Lines uneven_lines(Random& random, int n);

/// A random block of at least `least` cells a side.
Block random_block(Random& random, const Cells& cells, int least = 1);

/// Makes a solid of what the cells hold, with their account.
Solid solid_of(std::string variant, Mesh input, const Cells& cells, double tolerance,
               Random& random);
/// Joins meshes without welding them.
void append(Mesh& mesh, Mesh part);
Mesh turned_over(Mesh mesh);
/// Gives every triangle three vertices of its own.
Mesh taken_apart(const Mesh& mesh);

/// A solid in one piece without cavities that touches itself nowhere: a few blocks that overlap.
Cells random_lump(Random& random);

/// What the topology of blocks may be if some of those that only touch do not meet.
std::set<Topology> topologies_apart(const Lines& lines, const std::vector<Block>& blocks);

/// Draws a tolerance as a share of the size of the lines.
double draw_tolerance(Random& random, const Lines& lines);

// One maker a kind. They leave the pose open, and `tolerance` at 0 if any will do.
Solid make_touching(Random& random);
Solid make_coincident(Random& random);
Solid make_nested(Random& random);
Solid make_overlapping(Random& random);
Solid make_thin(Random& random);
Solid make_inverted(Random& random);
Solid make_doubled(Random& random);
Solid make_open(Random& random);
Solid make_torn(Random& random);
Solid make_voxels(Random& random);
Solid make_spun(Random& random);
Solid make_wire(Random& random);
Solid make_sound(Random& random);
Solid make_expression(Random& random);

}  // namespace kdm::truth
