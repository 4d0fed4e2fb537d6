// SPDX-License-Identifier: MIT
// Splits through creases and corners of the surface: the paper's second heuristic (5.1.2 (2)).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "prepare/surface.h"
#include "split/split_rules.h"
#include "split/triangle_lists.h"

namespace kdm {

/// Proposes splits of cells through or near *feature points*: points where planes of several
/// directions meet. One is the minimiser of the primal quadric of the planes of the triangles that
/// lie wholly in the cell. Up to six more lie on the cell's sides, which the paper calls
/// half-faces: each is the minimiser of the quadric of the lines in which triangles cut the side,
/// as far as the lines end within it. One object serves cell after cell.
class FeatureFinder {
 public:
  explicit FeatureFinder(const Surface& surface) : surface_(surface) {}

  /// Returns a split of the cell, or nothing if the cell has no feature points or is too thin to be
  /// split. `entries` must hold all triangles that meet the cell. Takes time linear in the number
  /// of entries.
  std::optional<Split> propose(const LatticeBox& box, std::span<const ListEntry> entries);

 private:
  struct Feature {
    Vec3 point;      // lattice units
    Vec3 certainty;  // how well the planes or lines determine each coordinate of the point, 0 to 1
  };

  void find_in_cell(const LatticeBox& box, std::span<const ListEntry> entries);
  void find_on_half_face(const LatticeBox& box, std::span<const ListEntry> entries, int axis,
                         bool high);
  double usefulness(const LatticeBox& box, int axis, double value) const;

  const Surface& surface_;
  std::vector<Feature> features_;  // of the cell at hand
};

}  // namespace kdm
