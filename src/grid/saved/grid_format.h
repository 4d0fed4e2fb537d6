// SPDX-License-Identifier: MIT
// The bytes of a saved grid, version 7. Numbers are little-endian; `n` is a variable-length number
// of seven bits a byte (io/bytes.h), `f64` a double, `z` a signed number as n: 0, -1, 1, -2, ...
// as 0, 1, 2, 3, ...
//
//   header   8 bytes   kMagic; a text mode or a 7-bit line would damage it visibly
//            u32       version
//            u64       bytes that follow the header
//            u64       checksum of these bytes (FNV-1a, 64 bits)
//   lattice  4 f64     origin x, y, z; step
//            3 f64     tolerance; winding threshold, 0: none; tolerance asked for, in model
//                      units
//   reports  17 n      of the input: vertices, triangles, boundary edges, non-manifold edges,
//                      boundary loops, degenerate, cancelled and duplicate faces, sewn edges,
//                      turned faces and parts, components, patched holes, lost, stray, thickened
//                      and rebuilt parts
//            4 n       of the grid: unresolved leaves, guessed faces, exact and thin parts
//            u8        1: input closed, 2: input flipped, 4: topology resolved, 8: a sheet's grid,
//                      16: the input's nesting is known, 32: of several operands, 64: simplified
//            6 f64     of the input: area of patches and of lost parts, of the largest lost one,
//                      sewing distance, rebuilding tolerance, extent
//            only if simplified: f64  how far its surface may have moved, above 0
//   sizes    n, n      splits, hits
//   cells    a split: n  8 (3 z + axis) + 4 stray + 2 (upper child is split) + (lower child is
//                      split), z being the split value less the middle of the cell; if stray:
//            n           the cell that is split; else it is the last of the cells known to be
//                      split that has not been, an upper child counting as earlier than its sibling
//   edges    a split: u8  two bits an edge, edge 0 lowest: the number of hits, or 3 for more; then
//                      for each edge with more: n, the number less 3
//   hits     a hit: n    position less the lowest possible: the edge's lower end, or one unit of
//                      2^-12 above the hit before (a sheet's: the hit before)
//            n           planes met so far less the number of its plane, so that 0 is a new one;
//                      for the first hit of an edge and all hits of sheets twice that, plus 1 if
//                      it is leaving
//            if new: 4 f64, z  normal and offset; source face less that of the plane before
//   links    bits      for each minimal face with more than two hits that is no strip, as
//                      `for_each_face` visits them, a bit a hit in the order of `for_each_hit`: 1
//                      where a link begins, 0 where the last link still open ends; of sheets for
//                      each face that is no strip, whatever `SheetLinkDecisions` ask, 1 for yes
//   rims     n         their number
//            a rim: n, 3 f64, 3 f64  half-edge less that of the rim before, less 1; point; normal
//   corners  n         their number
//            a corner: n, 3 f64  as a rim's, without normal; if simplified, then u8  1: joined
//   operands  only of several:
//            n         their number
//            an operand: n and f64  its report, as reports.h lists the values: counts and flags as
//                      n, measures as f64
//            a plane: n  the number of its operand; of none, the number of operands
//   exact    n         how many vertices exact parts have
//            a vertex: 3 f32  its position, in model units
//            n         their number of triangles
//            a triangle: 3 n, z  vertices; source face less that of the triangle before; of
//                      several operands also n, the number of its operand, as for a plane
//
// What follows from this is not stored: boxes, active sides, whether hits are reversed, a solid's
// links of two hits, links across strips, and where half-edges start.
#pragma once

#include <cstdint>
#include <string_view>

#include "kdmanifold/types.h"

namespace kdm::grid_format {

inline constexpr std::string_view kMagic = "\x89kdgrid\n";
inline constexpr std::uint32_t kVersion = 7;
inline constexpr std::size_t kHeaderBytes = 8 + 4 + 8 + 8;

/// Planes are numbered by 30 bits, cells and half-edges by 31 and 32.
inline constexpr std::uint64_t kMostHits = (1u << 30) - 1;
inline constexpr std::uint64_t kMostSplits = (1u << 30) - 1;

/// An edge with this many hits or more has the number spelled out.
inline constexpr Index kManyHits = 3;

inline constexpr unsigned kClosed = 1, kFlipped = 2, kTopologyResolved = 4, kSheet = 8;
inline constexpr unsigned kNestingKnown = 16, kSeveralOperands = 32, kSimplified = 64;
inline constexpr unsigned kBelowIsSplit = 1, kAboveIsSplit = 2, kStray = 4;

inline std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t state = 0xcbf29ce484222325u;
  for (const char byte : bytes) {
    state = (state ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
  }
  return state;
}

constexpr std::uint64_t from_signed(std::int64_t value) {
  return value < 0 ? ~(static_cast<std::uint64_t>(value) << 1)
                   : static_cast<std::uint64_t>(value) << 1;
}
constexpr std::int64_t to_signed(std::uint64_t value) {
  const auto half = static_cast<std::int64_t>(value >> 1);
  return (value & 1) != 0 ? -1 - half : half;
}

}  // namespace kdm::grid_format
