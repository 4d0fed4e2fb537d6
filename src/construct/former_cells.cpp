// SPDX-License-Identifier: MIT
#include "construct/former_cells.h"

namespace kdm {

std::array<FormerCell, 2> halves_of(const FormerCell& cell, const FormerCells& former) {
  const Cell& whole = former.cells[cell.cell];
  const Split split{whole.axis(), whole.value()};
  std::array<FormerCell, 2> halves{cell, cell};
  auto& [below, above] = halves;
  cut_edges(
      split, former.crossings.all, [](bool, bool, int counted) { return counted; }, below, above);
  for (int i = 0; i < 4; ++i) {
    const EdgeId edge = 4 * whole.split() + static_cast<EdgeId>(i);
    const std::vector<Index>& begin = former.crossings.edge_begin;
    hand_down_edge(split.axis, i, {begin[edge], begin[edge + 1]}, below.edges, above.edges);
  }
  below.cell = whole.below();
  above.cell = whole.above();
  return halves;
}

bool same_border(const CellBorder& a, const std::vector<ClassifiedCrossing>& crossings_of_a,
                 const CellBorder& b, const std::vector<ClassifiedCrossing>& crossings_of_b,
                 const Surface& surface, SolidBits moved) {
  if (a.state != b.state) return false;
  for (std::size_t edge = 0; edge < a.edges.size(); ++edge) {
    const EdgeRange& of_a = a.edges[edge];
    const EdgeRange& of_b = b.edges[edge];
    if (of_a.end - of_a.begin != of_b.end - of_b.begin) return false;
    for (Index i = 0; i < of_a.end - of_a.begin; ++i) {
      const ClassifiedCrossing& crossing = crossings_of_a[of_a.begin + i];
      if (crossing != crossings_of_b[of_b.begin + i]) return false;
      if ((moved >> surface.solid_of[crossing.triangle()] & 1) != 0) return false;
    }
  }
  return true;
}

void copy_splits(const FormerCells& former, CellId former_cell, CellId cell, MadeCells& made,
                 FormerCells& notes) {
  const SplitId first = former.cells[former_cell].split();
  const SplitId end = former.splits[first].end;
  const SplitId number = made.splits();  // of the first split
  const auto copy_of = [&](const Cell& old) {
    if (old.leaf()) return Cell();
    return Cell(2 * (old.split() - first + number) + 1, old.axis(), old.value());
  };
  made.cells[cell] = copy_of(former.cells[former_cell]);
  for (CellId old = 2 * first + 1; old <= 2 * end; ++old)
    made.cells.push_back(copy_of(former.cells[old]));
  made.crossings.append(former.crossings, 4 * first, 4 * end);
  notes.taken_over += end - first;
  const SplitNote& whole = former.splits[first];
  const auto unresolved = static_cast<Index>(made.unresolved.size()) - whole.unresolved_begin;
  made.unresolved.insert(made.unresolved.end(), former.unresolved.begin() + whole.unresolved_begin,
                         former.unresolved.begin() + whole.unresolved_end);
  for (SplitId split = first; split < end; ++split) {
    SplitNote& note = notes.splits.emplace_back(former.splits[split]);
    note.end += number - first;
    note.unresolved_begin += unresolved;
    note.unresolved_end += unresolved;
  }
}

}  // namespace kdm
