// SPDX-License-Identifier: MIT
// Mesh vertices at which the surface bends.
#pragma once

#include <span>
#include <vector>

#include "mesh/groups.h"
#include "prepare/surface.h"

namespace kdm {

/// A mesh vertex with triangles whose planes differ.
struct Bend {
  Index point;  ///< its number
  LatticePoint at;
};

/// All those of a surface at which two planes may differ by this angle or more, given by the cosine
/// of its half: one that is found bends by that at least. Linear.
class Bends {
 public:
  Bends(const Surface& surface, std::span<const Plane> planes, double cosine_of_half);

  const std::vector<Bend>& all() const { return all_; }
  /// Triangles with the bend's vertex; those without area have no plane and are left out.
  std::span<const Index> triangles_round(const Bend& bend) const { return round_.of(bend.point); }

 private:
  std::vector<Bend> all_;
  Groups round_;  // by point
};

}  // namespace kdm
