// SPDX-License-Identifier: MIT
// The kd-tree grid: the volumetric representation that everything works on (paper section 3).
#pragma once

#include <memory>

#include "kdmanifold/types.h"

namespace kdm {

struct GridData;

/// What the grid was built from.
struct InputReport {
  Index vertices = 0;  ///< after welding vertices of exactly equal position
  Index triangles = 0;
  bool closed = false;  ///< every edge is used equally often in both directions
  Index boundary_edges = 0;
  Index boundary_loops = 0;  ///< of the edges at which the surface ends: those with one face, and
                             ///< faces that find none at their edge that runs against them
                             ///< (`kRepair`: once it is sewn and turned)
  Index non_manifold_edges = 0;  ///< edges with three or more faces
  Index degenerate_faces = 0;    ///< faces without area on the lattice; they take no part
  Index cancelled_faces = 0;     ///< faces that lie back to back in pairs; they take no part
  Index duplicate_faces = 0;     ///< `kRepair`: further faces over the same corners; they take no
                                 ///< part
  Index sewn_edges = 0;          ///< `kRepair`: pairs of boundary edges, no further apart than the
                                 ///< tolerance, that were joined
  Index turned_faces = 0;        ///< `kRepair`: faces that were turned to agree and look outwards
  Index components = 0;          ///< parts joined by edges
  bool flipped = false;          ///< the input was inside out and has been turned
  double lattice_step = 0;  ///< what input positions were rounded to for decisions, model units
};

struct GridStats {
  Index cells = 0;  ///< nodes of the kd-tree
  Index leaves = 0;
  Index hits = 0;         ///< intersections of the surface with grid edges
  int depth = 0;          ///< of the deepest leaf
  bool sheet = false;     ///< built as a sheet: results may have a boundary
  std::size_t bytes = 0;  ///< memory held by the grid
  /// In model units: what was asked for, or more where a surface to be repaired would have taken
  /// beyond all measure. Of strategies that ask for none, what extraction goes by.
  double tolerance = 0;
  /// `kRepair`: winding numbers above it are inside; 0 where the surface is closed and none had to
  /// be asked for.
  double winding_threshold = 0;
  /// Adaptive, octree: no leaf was given up, every ambiguous face was traced; the output of an
  /// embedded input is then homeomorphic to it. Other strategies do not look: false.
  bool topology_resolved = false;
  Index unresolved_leaves = 0;  ///< leaves given up at the depth limit or below the size floor
  Index ambiguous_faces = 0;    ///< minimal faces with more than two hits
  Index invented_hits = 0;      ///< hits of no input face, where holes were closed
  Index guessed_faces = 0;      ///< of these, the ones a trace of the input could not decide
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

  const GridStats& stats() const;
  const InputReport& input() const;

  /// For the library's own algorithms; not part of the interface.
  const GridData& data() const;

 private:
  std::unique_ptr<GridData> data_;
};

}  // namespace kdm
