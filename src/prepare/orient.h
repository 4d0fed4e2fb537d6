// SPDX-License-Identifier: MIT
// Finds which triangles must be turned for the surface to face outwards.
#pragma once

#include <span>
#include <vector>

#include "mesh/marks.h"
#include "mesh/numbers.h"
#include "mesh/topology.h"

namespace kdm {

/// A part of the mesh: triangles joined by edges of exactly two (copies over the same three points
/// count once).
struct OrientedPart {
  TriangleId first = kNone;  ///< the lowest of its triangles
  Index triangles = 0;       ///< how many triangles it has, copies among them
  double area = 0;           ///< of its triangles without copies, in squared model units
  bool closed = false;       ///< once turned, it uses every edge equally often both ways
  bool oriented = true;      ///< its triangles agreed before
  bool enclosed = false;     ///< fewer than 1/20 of the rays that start on it leave the mesh
  bool flipped = false;      ///< most of its area must be turned
  bool sheet = false;        ///< it bounds nothing: nearly flat and open, or closed without volume
};

struct Orientation {
  Marks must_turn;          ///< the triangles that must be turned
  std::vector<Index> part;  ///< for each triangle the number of its part
  /// For each triangle the first one over the same three points; kNone if it is the first one
  /// itself. Such a copy comes to face the same way as the first one.
  std::vector<TriangleId> copy_of;
  std::vector<OrientedPart> parts;  ///< in order of their first triangles
  Index flipped_triangles = 0;      ///< how many must be turned
  Index flipped_parts = 0;          ///< parts that are `flipped`
  Index sheets = 0;                 ///< parts that are a `sheet`
  Index copies = 0;                 ///< triangles that are copies
  Index contradictions = 0;         ///< edges whose two triangles cannot agree (Moebius strips)

  bool changes_nothing() const { return flipped_triangles == 0; }
};

// clang-format off
/// Finds how triangles must be turned for neighbours to agree (see `orient_neighbours`), and then
/// which parts must be turned as a whole:
/// - A closed part that can be seen from outside gets a positive volume.
/// - An open part turns its outer side outwards: the side from which clearly more rays leave the
///   mesh. If about as many leave from both sides, it is a sheet: it gets a positive volume about
///   its centroid or, if it is flat, stays as it is.
/// - An enclosed part, of which next to nothing can be seen, stays as it is if its triangles agreed
///   on two thirds of its area: so a cavity stays a cavity, and a solid within a solid stays one.
///   If most of the area that can be seen was inside out, though, the whole mesh was, and enclosed
///   parts are turned as well. A part whose triangles did not agree gets a positive volume.
///
/// At most 16,384 rays are followed for open parts, the same on every platform; if there are more
/// than 1,024 open parts, only the largest are looked at, and the others stay as they are. Takes
/// linear time up to sorting, and for each ray a time that is logarithmic on usual meshes. The
/// corners of each triangle must be distinct, and coordinates at most 1e150. `topology` must be that
/// of the triangles.
Orientation orient(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                   const Topology& topology);
// clang-format on

}  // namespace kdm
