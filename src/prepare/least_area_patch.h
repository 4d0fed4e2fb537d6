// SPDX-License-Identifier: MIT
// Closes a hole by triangles over its corners with the least area, without inserting points.
//
// The dynamic programme over all triangulations of a polygon in space is that of G. Barequet and
// M. Sharir, Filling Gaps in the Boundary of a Polyhedron, 1995; to count folds before area follows
// P. Liepa, Filling Holes in Meshes, 2003, who compares the widest angles.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/numbers.h"

namespace kdm {

/// Makes patches for holes. Working arrays are kept between calls.
class LeastAreaPatch {
 public:
  /// `points` must be scaled to about 1. `edges` holds the edges of the mesh between points at
  /// holes, each as lower point * 2^32 + upper point, ascending. Both must outlive this.
  LeastAreaPatch(const std::vector<Vec3>& points, const std::vector<std::uint64_t>& edges)
      : points_(points), edges_(edges) {}

  /// Appends to `out` the triangles of a patch over the polygon, oriented like it: two less than
  /// its corners. `beyond[i]` is the normal, of any length, of the triangle on the other side of
  /// the edge from corner i to the next one; zero if there is none. The corners must be different
  /// points.
  ///
  /// Of all patches the one is made that has the fewest folds and, of these, the least area. A fold
  /// is an edge at which the surface turns by more than 160 degrees, a chord that is an edge of the
  /// mesh already, or a triangle without height, behind which a fold may hide. The time grows with
  /// the third power of the corners. Therefore polygons of more than 500 corners, or fewer once
  /// much time is spent, are divided first: a patch over some of the corners, spread evenly, leaves
  /// polygons along the rest.
  void make(std::span<const PointId> polygon, std::span<const Vec3> beyond,
            std::vector<Triangle>& out);

  /// Tells whether the time for polygons of so many corners is such that none of them is divided
  /// because of the others. Then their patches do not depend on each other.
  static bool is_little_work(std::span<const std::size_t> corners);

 private:
  struct Cost {
    std::uint32_t folds = 0;
    double area = 0;

    friend Cost operator+(const Cost& a, const Cost& b) {
      return {a.folds + b.folds, a.area + b.area};
    }
    friend bool operator<(const Cost& a, const Cost& b) {
      return a.folds != b.folds ? a.folds < b.folds : a.area < b.area;
    }
  };

  void divide(std::span<const PointId> polygon, std::span<const Vec3> beyond,
              std::vector<Triangle>& out);
  void run(std::span<const PointId> polygon, std::span<const Vec3> beyond,
           std::vector<Triangle>& out);
  void find_used_chords(std::span<const PointId> polygon);
  void find_best(std::size_t low, std::size_t high);
  Vec3 normal(std::size_t a, std::size_t b, std::size_t c) const;
  Vec3 normal_below(std::size_t low, std::size_t high) const;
  std::size_t at(std::size_t low, std::size_t high) const { return low * size_ + high; }

  const std::vector<Vec3>& points_;
  const std::vector<std::uint64_t>& edges_;
  std::uint64_t work_ = 0;  // triangles looked at so far

  // Of the polygon at hand. Arrays with an entry for each chord hold what is best for the part of
  // the polygon from its lower to its higher corner.
  std::size_t size_ = 0;
  std::vector<Vec3> corners_;
  std::vector<Vec3> beyond_;
  std::vector<Cost> cost_;
  std::vector<std::uint16_t> apex_;  // of the triangle on the chord
  std::vector<char> used_;           // the chord is an edge of the mesh
};

}  // namespace kdm
