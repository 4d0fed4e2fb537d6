// SPDX-License-Identifier: MIT
// The kd-tree grid: cells that are split along planes x, y or z = constant, and the hits of the
// surface with the edges of the cells (paper section 3). Everything works on it.
#pragma once

#include <memory>
#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

struct GridData;

/// What the grid was built from.
struct InputReport {
  Index vertices = 0;        ///< after joining vertices of exactly equal position
  Index triangles = 0;       ///< number of the input's triangles
  bool closed = false;       ///< every edge is used equally often in both directions
  Index boundary_edges = 0;  ///< edges with one face
  /// Closed rounds of the edges at which the surface ends: edges with one face, and edges of faces
  /// without a neighbour that runs against them. `kRepair`: counted once the surface is sewn and
  /// turned.
  Index boundary_loops = 0;
  Index non_manifold_edges = 0;  ///< edges with three or more faces
  /// Faces without area once positions are rounded to the lattice; they take no part.
  Index degenerate_faces = 0;
  Index cancelled_faces = 0;  ///< faces that lie back to back in pairs; they take no part
  /// `kRepair`, `kOdd`: faces over the same corners as others; they take no part.
  Index duplicate_faces = 0;
  Index sewn_edges = 0;  ///< `kRepair`: pairs of boundary edges, no further apart than the
                         ///< tolerance, that were joined
  /// `kRepair`: faces that were turned to agree with their neighbours and look outwards.
  Index turned_faces = 0;
  /// `kRepair`: closed parts that were inside out and have been turned, their faces counting as
  /// turned too. Cavities are none. 0 if the whole input was inside out (`flipped`).
  Index turned_parts = 0;
  /// `kRepair`: false if so many closed parts overlap that nobody has looked which lie in which;
  /// then none was turned by itself.
  bool nesting_known = true;
  Index components = 0;  ///< parts joined by edges
  bool flipped = false;  ///< the input was inside out and has been turned
  /// `kRepair`: holes that were closed by patches over their corners, and the area of these
  /// patches.
  Index patched_holes = 0;
  double patch_area = 0;
  /// `kRepair`: parts that were left out because they bound nothing, their area, and the area of
  /// the largest of them.
  Index lost_parts = 0;
  double lost_area = 0;
  double largest_lost = 0;
  Index thickened_parts = 0;  ///< `kRepair`: parts that bound nothing and were given a thickness
  /// Parts that were built by themselves, with what the tolerance was for them at most, in model
  /// units. `kRepair`: those that neither sewing nor patches close, beside others that are closed.
  /// `kRepair`, `kPositive`: thin parts that cross or touch each other, which their union replaces.
  Index rebuilt_parts = 0;
  double rebuilding_tolerance = 0;
  /// `kRepair`: the distance up to which boundary edges were joined, in model units: the tolerance,
  /// or more where most of them lie further from their partners; 0 if none was joined.
  double sewing_distance = 0;
  /// Parts that hold next to no area and lie far from the rest; `extent` leaves them out.
  Index stray_parts = 0;
  /// The length in model units that a relative tolerance is a fraction of: the diagonal of the
  /// bounding box, without stray parts.
  double extent = 0;
  /// Step of the lattice to which positions were rounded for decisions, in model units.
  double lattice_step = 0;
};

/// How large a grid is, and how its construction went.
struct GridStats {
  Index cells = 0;        ///< nodes of the kd-tree
  Index leaves = 0;       ///< cells that are not split
  Index hits = 0;         ///< intersections of the surface with grid edges
  int depth = 0;          ///< depth of the deepest leaf; the root has 0
  bool sheet = false;     ///< built by the inside rule `kSheet`: results may have a boundary
  std::size_t bytes = 0;  ///< memory held by the grid
  /// In model units: the tolerance that was asked for; 0 if none was.
  double asked_tolerance = 0;
  /// In model units: how far the grid's surface may be from the input. This is the tolerance that
  /// was asked for, 0.8 times it if the result is to be reduced (see `make_manifold`), or a wider
  /// one where a surface to be repaired would have taken beyond all measure. For strategies without
  /// a tolerance: the one that extraction goes by.
  double tolerance = 0;
  /// In model units: how far `simplify` may have moved the surface since, which comes on top. 0: it
  /// was not simplified.
  double simplified = 0;
  /// `kRepair`: winding numbers above this are inside; 0 where the surface is closed and none had
  /// to be asked for.
  double winding_threshold = 0;
  /// `kAdaptive`, `kOctree`, `kFeature`: no leaf was given up, and every ambiguous face was traced;
  /// the result of an embedded input is then homeomorphic to it, and where shells or operands
  /// cross, to the boundary of what the inside rule or the expression makes of them. Other
  /// strategies do not look: false.
  bool topology_resolved = false;
  Index unresolved_leaves = 0;  ///< leaves given up at the depth limit or the least size
  /// Centres of these leaves, in model units: of all, or, of more than 1,000, of every second,
  /// fourth and so on. Saved grids do not keep them.
  std::vector<Vec3> unresolved_positions;
  /// `kAdaptive`, `kOctree`, `kFeature`: parts about as thin as the tolerance that meet no others.
  /// They are taken over just as they are in the input, or as they were rebuilt; and their
  /// triangles.
  Index exact_parts = 0;
  Index exact_triangles = 0;
  Index thin_parts = 0;       ///< further thin parts, whose thickness may differ in the result
  Index ambiguous_faces = 0;  ///< minimal faces with more than two hits
  Index invented_hits = 0;    ///< hits of no input face, where holes were closed
  /// With `minimum_thickness` and `minimum_gap`: area of the solid's surface that is thinner than
  /// the one, and that bounds gaps narrower than the other, in square model units. Saved grids do
  /// not keep them.
  double thin_area = 0;
  double narrow_area = 0;
  Index guessed_faces = 0;  ///< ambiguous faces that a trace of the input could not decide
};

/// A kd-tree grid with its hits and links. Movable and copyable; a moved-from grid is empty.
class Grid {
 public:
  Grid();
  explicit Grid(std::unique_ptr<GridData> data);
  Grid(const Grid& other);
  Grid& operator=(const Grid& other);
  Grid(Grid&&) noexcept;
  Grid& operator=(Grid&&) noexcept;
  ~Grid();

  /// Returns how large the grid is.
  const GridStats& stats() const;
  /// Returns what the grid was built from.
  const InputReport& input() const;
  /// Returns what the operands of a Boolean operation are, in their order; `input` is then the sum.
  /// Empty if the grid was built from one mesh.
  const std::vector<InputReport>& operands() const;

  /// Returns the representation, for the library's own algorithms; not part of the interface.
  const GridData& data() const;

 private:
  std::unique_ptr<GridData> data_;
};

}  // namespace kdm
