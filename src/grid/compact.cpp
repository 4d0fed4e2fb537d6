// SPDX-License-Identifier: MIT
// Removes splits in place, and numbers a grid consecutively again. Nothing but planes changes its
// place among its like, so all new numbers are ranks.
#include "grid/compact.h"

#include <algorithm>

#include "geometry/assert.h"
#include "grid/count_stats.h"
#include "grid/faces.h"
#include "grid/splitting_edges.h"

namespace kdm {
namespace {

// Numbers planes in the order in which they are asked for, and drops the others.
class PlaneSelection {
 public:
  explicit PlaneSelection(GridData& grid) : grid_(grid), new_number_(grid.planes.size(), kNone) {}

  PlaneId number_of(PlaneId plane) {
    if (new_number_[plane] == kNone) {
      new_number_[plane] = static_cast<PlaneId>(planes_.size());
      planes_.push_back(grid_.planes[plane]);
      source_faces_.push_back(grid_.source_faces[plane]);
      if (!grid_.source_operands.empty()) {
        source_operands_.push_back(grid_.source_operands[plane]);
      }
    }
    return new_number_[plane];
  }

  void apply() {
    planes_.shrink_to_fit();
    source_faces_.shrink_to_fit();
    source_operands_.shrink_to_fit();
    grid_.planes = std::move(planes_);
    grid_.source_faces = std::move(source_faces_);
    grid_.source_operands = std::move(source_operands_);
  }

 private:
  GridData& grid_;
  std::vector<PlaneId> new_number_;
  std::vector<Plane> planes_;
  std::vector<Index> source_faces_;
  std::vector<Index> source_operands_;
};

class Compaction {
 public:
  Compaction(GridData& grid, DisjointSets& merged_cells, const Marks& gone)
      : grid_(grid),
        merged_cells_(merged_cells),
        gone_(gone),
        cell_of_split_(cells_of_splits(grid)),
        new_split_(grid.splits(), kNone),
        new_hit_(grid.hits.size(), kNone) {}

  void run() {
    number_splits_and_hits();
    // Starts and rims are translated by the old numbers of hits, so hits come last.
    move_half_edges();
    move_kept(grid_.rims);
    move_kept(grid_.corners);
    move_hits();
    move_cells();
  }

 private:
  void number_splits_and_hits() {
    SplitId splits = 0;
    HitId hits = 0;
    for (SplitId k = 0; k < new_split_.size(); ++k) {
      if (cell_of_split_[k] == kNone) continue;
      new_split_[k] = splits++;
      for (int i = 0; i < 4; ++i) {
        for (const HitId h : grid_.edge_hits(k, i)) {
          if (!gone_.test(h)) new_hit_[h] = hits++;
        }
      }
    }
  }

  CellId new_cell(CellId cell) const {
    if (cell == 0) return 0;
    const SplitId maker = new_split_[(cell - 1) / 2];
    KDM_ASSERT(maker != kNone, "what lives is in living cells");
    return 2 * maker + 2 - cell % 2;
  }

  HalfEdgeId new_half_edge(HalfEdgeId half_edge) const {
    if (half_edge == kNone) return kNone;
    KDM_ASSERT(new_hit_[half_edge / 3] != kNone, "what lives is linked to what lives");
    return 3 * new_hit_[half_edge / 3] + half_edge % 3;
  }

  void move_half_edges() {
    std::size_t kept = 0;
    for (HalfEdgeId h = 0; h < grid_.opposite.size(); ++h) {
      if (new_hit_[h / 3] == kNone) continue;
      const CellId leaf = new_cell(merged_cells_.find(grid_.start_leaf(h)));
      grid_.start[kept] = leaf | (grid_.crosses_strip(h) ? GridData::kStrip : 0);
      grid_.opposite[kept] = new_half_edge(grid_.opposite[h]);
      ++kept;
    }
    grid_.start.resize(kept);
    grid_.opposite.resize(kept);
  }

  // Rims or corners.
  template <typename Kept>
  void move_kept(std::vector<Kept>& all) const {
    std::erase_if(all, [&](const Kept& one) { return new_hit_[one.half_edge / 3] == kNone; });
    for (Kept& one : all) one.half_edge = new_half_edge(one.half_edge);
  }

  // With their edges and planes.
  void move_hits() {
    PlaneSelection planes(grid_);
    std::vector<HitId> edge_begin{0};
    edge_begin.reserve(grid_.edge_begin.size());
    HitId kept = 0;
    for (SplitId k = 0; k < new_split_.size(); ++k) {
      if (new_split_[k] == kNone) continue;
      for (int i = 0; i < 4; ++i) {
        for (const HitId h : grid_.edge_hits(k, i)) {
          if (new_hit_[h] == kNone) continue;
          const Hit hit = grid_.hits[h];
          grid_.hits[kept++] =
              Hit(hit.position, planes.number_of(hit.plane()), hit.leaving(), hit.reversed());
        }
        edge_begin.push_back(kept);
      }
    }
    grid_.hits.resize(kept);
    grid_.edge_begin = std::move(edge_begin);
    planes.apply();
  }

  void move_cells() {
    const auto splits = static_cast<Index>(new_split_.size() -
                                           std::count(new_split_.begin(), new_split_.end(), kNone));
    std::vector<Cell> cells(2 * std::size_t{splits} + 1);
    for (SplitId k = 0; k < new_split_.size(); ++k) {
      if (new_split_[k] == kNone) continue;
      const Cell& split = grid_.cells[cell_of_split_[k]];
      cells[new_cell(cell_of_split_[k])] = Cell(2 * new_split_[k] + 1, split.axis(), split.value());
    }
    grid_.cells = std::move(cells);
    mark_active_sides(grid_);
  }

  GridData& grid_;
  DisjointSets& merged_cells_;
  const Marks& gone_;                  // hits that go though their edges stay
  std::vector<CellId> cell_of_split_;  // kNone: the split was removed
  std::vector<SplitId> new_split_;     // by old number; kNone: removed
  std::vector<HitId> new_hit_;         // by old number; kNone: dead
};

void number_again(GridData& grid, DisjointSets& merged_cells, const Marks& gone) {
  Compaction(grid, merged_cells, gone).run();
  grid.stats.ambiguous_faces = count_ambiguous_faces(grid);
  count_stats(grid);
}

}  // namespace

void remove_split(GridData& grid, CellId cell, DisjointSets& merged_cells) {
  const Cell split = grid.cells[cell];
  KDM_ASSERT(!split.leaf() && grid.cells[split.below()].leaf() && grid.cells[split.above()].leaf(),
             "splits are removed from the leaves on");
  grid.cells[cell] = Cell();
  merged_cells.join(cell, split.below());
  merged_cells.join(cell, split.above());
}

void compact(GridData& grid, DisjointSets& merged_cells) {
  number_again(grid, merged_cells, Marks(grid.hits.size()));
}

void remove_hits(GridData& grid, const Marks& gone) {
  DisjointSets merged_cells(grid.cells.size());
  number_again(grid, merged_cells, gone);
}

void compact(GridData& grid) {
  DisjointSets merged_cells(grid.cells.size());
  compact(grid, merged_cells);
}

}  // namespace kdm
