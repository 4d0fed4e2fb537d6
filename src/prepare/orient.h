// SPDX-License-Identifier: MIT
// Which triangles must be turned for the surface to look outwards.
#pragma once

#include <span>
#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

/// Triangles joined by edges of exactly two (copies over the same corners counting once).
struct OrientedPart {
  Index first = kNone;    ///< its lowest triangle
  Index triangles = 0;    ///< copies among them
  double area = 0;        ///< model units squared, without copies
  bool closed = false;    ///< once turned, it uses every edge equally often in both directions
  bool oriented = true;   ///< its triangles agreed from the start
  bool enclosed = false;  ///< next to nothing of it can be seen from outside
  bool flipped = false;   ///< most of its area is turned
  bool sheet = false;     ///< bounds nothing: nearly flat and open, or closed without volume
};

struct Orientation {
  std::vector<char> flip;   ///< 1: this triangle must be turned
  std::vector<Index> part;  ///< of each triangle
  /// The first triangle over the same three corners, if there is an earlier one, else kNone. Copies
  /// are turned as it is.
  std::vector<Index> copy_of;
  std::vector<OrientedPart> parts;  ///< in order of their first triangles
  Index flipped_triangles = 0;
  Index flipped_parts = 0;
  Index sheets = 0;
  Index copies = 0;
  Index contradictions = 0;  ///< edges whose two triangles cannot agree (Moebius strips)

  bool changes_nothing() const { return flipped_triangles == 0; }
};

/// Turns neighbours to agree (`orient_neighbours`), then each part as a whole:
/// - A closed part that can be seen from outside gets a positive volume.
/// - An open one shows its outer side, the one from which clearly more rays leave the mesh. Where
///   both see as much it is a sheet: it gets a positive volume about its centroid or, flat, stays.
/// - An enclosed one keeps its direction if two thirds of its area had it: a cavity stays a cavity,
/// a
///   solid within a solid stays that. If most of what can be seen was inside out, though, the whole
///   mesh was, and what is enclosed is turned as well. Without a direction it gets a positive
///   volume.
///
/// Rays are deterministic, 16,384 at most for open parts: of more than 1,024 only the largest are
/// looked at, the others stay. Linear up to sorting, but for the rays (logarithmic on usual
/// meshes). `triangles` have distinct corners, `points` coordinates of at most 1e150.
Orientation orient(std::span<const Triangle> triangles, const std::vector<Vec3>& points);

}  // namespace kdm
