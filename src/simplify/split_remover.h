// SPDX-License-Identifier: MIT
// Removes the splits of a grid one by one, the cheapest first (paper 4.1).
#pragma once

#include <limits>
#include <vector>

#include "simplify/near_surface.h"

namespace kdm {

/// Removes splits between leaves as long as the surface keeps its topology and its distance. A
/// split costs what its removal makes the largest on-metric of a hit: the hits that vanish are
/// added to the better of the two at the ends of their row.
class SplitRemover {
 public:
  /// `work` and `near` must outlive this. Removals that cost more than `most_cost`, in squared
  /// lattice units, are left.
  SplitRemover(WorkGrid& work, NearSurface& near, double most_cost);

  /// Removes the next split. Returns false if none is left that may be removed.
  bool remove_next();

  Index removed() const { return removed_; }
  /// Returns the largest cost of a removal so far.
  double largest_cost() const { return largest_cost_; }

 private:
  struct Entry {
    double cost;
    SplitId split;
    Index version;  // of the split, when the cost was found
  };
  static bool is_later(const Entry& a, const Entry& b);

  void push(CellId cell);
  double cost() const;
  HitId absorbing_hit(const RemovedRow& row, double& error) const;
  bool try_removal(CellId cell);
  void push_neighbours(CellId cell);
  void push_owners(HalfEdgeId start);

  WorkGrid& work_;
  NearSurface& near_;
  double most_cost_;
  Removal removal_;
  std::vector<Entry> heap_;
  std::vector<Index> version_;   // per split
  std::vector<Vec3> positions_;  // of the pieces' vertices
  std::vector<CellId> stale_;    // cells whose splits are to be looked at again
  Index removed_ = 0;
  double largest_cost_ = 0;
};

}  // namespace kdm
