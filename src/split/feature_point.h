// SPDX-License-Identifier: MIT
// Where the surface in a cell has features: the paper's second heuristic (5.1.2 (2)).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "prepare/surface.h"
#include "split/split_rules.h"
#include "split/triangle_lists.h"

namespace kdm {

/// Proposes splits through or near the minimisers of a cell's primal quadric, made of the planes of
/// the triangles fully inside it, and of the two-dimensional quadrics of its half-faces, made of
/// the lines in which triangles cut them, as far as these lie fully inside the half-face.
class FeatureFinder {
 public:
  explicit FeatureFinder(const Surface& surface) : surface_(surface) {}

  /// Nothing where the cell has no feature, or is too small for a split.
  std::optional<Split> propose(const LatticeBox& box, std::span<const ListEntry> entries);

 private:
  // A minimiser, and how well the planes or lines determine each of its coordinates, 0 to 1.
  struct Feature {
    Vec3 point;
    Vec3 certainty;
  };

  void find_in_cell(const LatticeBox& box, std::span<const ListEntry> entries);
  void find_on_half_face(const LatticeBox& box, std::span<const ListEntry> entries, int axis,
                         bool high);
  double score(const LatticeBox& box, int axis, double value) const;

  const Surface& surface_;
  std::vector<Feature> features_;
};

}  // namespace kdm
