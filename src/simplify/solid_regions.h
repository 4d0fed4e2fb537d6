// SPDX-License-Identifier: MIT
// The regions into which the surface of a grid divides space: bodies of material, the cavities in
// them, and what is around them all.
#pragma once

#include <array>
#include <vector>

#include "grid/grid_data.h"
#include "mesh/disjoint_sets.h"
#include "mesh/groups.h"

namespace kdm {

/// One of the closed surfaces of a grid. The region just within it has its number.
struct BoundingSurface {
  Box bounds;         ///< lattice units
  double volume = 0;  ///< positive: material is within
  Index handles = 0;
  Index around = kNone;  ///< the region just around it; kNone: the one around all
  bool pillow = false;   ///< it is a pillow, which is no part of the result and bounds no region
  bool sure = true;      ///< it is known what is within it and around it, as regions
};

/// The surfaces of a solid's grid, one triangle for each hit and those that the grid has as they
/// are, and what they bound. What lies in what is found by points (mesh/nesting.h); then it is held
/// against what lies between hits that are neighbours round a minimal face.
class SolidRegions {
 public:
  explicit SolidRegions(const GridData& grid);

  /// Also pillows. What is one of their numbers may be the number of a region.
  const std::vector<BoundingSurface>& surfaces() const { return surfaces_; }
  Index surface_of_hit(HitId hit) const { return surface_of_[hit]; }
  Index surface_of_exact(Index triangle) const { return surface_of_[hits_ + triangle]; }
  bool is_exact(Index surface) const { return surface >= exact_; }

  bool is_material(Index region) const { return surfaces_[region].volume > 0; }
  /// Returns the region on the side of a surface where there is material, or where there is none;
  /// of a pillow too, as far as it is known and is not the void in it. kNone: the one around all.
  Index region_beside(Index surface, bool material) const {
    return beside_[material ? 1 : 0][surface];
  }
  /// Returns the triangles of the region's surfaces, turned outwards as seen from it.
  std::vector<std::array<Vec3, 3>> boundary_of(Index region) const;

 private:
  void place_triangles(const GridData& grid);
  void find_surfaces(const GridData& grid);
  void measure();
  void find_enclosing();
  void group();
  void find_beside(const GridData& grid);
  void compare(bool material, DisjointSets& same);

  Mesh mesh_;  // lattice units; a triangle for each hit, then those of the exact parts
  Index hits_;
  Index exact_ = 0;                // the first of the exact parts' surfaces
  std::vector<Index> surface_of_;  // per triangle
  std::vector<BoundingSurface> surfaces_;
  Groups triangles_of_;                       // per surface
  Groups within_;                             // per region: the surfaces that it is around
  std::array<std::vector<Index>, 2> beside_;  // per surface, in the void and in material
};

}  // namespace kdm
