// SPDX-License-Identifier: MIT
// Makes hits of crossings, for models that only count.
#pragma once

#include "inside/crossing.h"
#include "inside/hit_writer.h"

namespace kdm {

/// Makes a hit of every crossing that bounds the solid, and of those that bound a gap or a sliver
/// with a grid vertex in it.
void write_hits(const EdgeCrossings& planned, HitWriter& writer);

}  // namespace kdm
