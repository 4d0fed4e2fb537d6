// SPDX-License-Identifier: MIT
#include "inside/write_hits.h"

#include "grid/splitting_edges.h"
#include "inside/gaps.h"

namespace kdm {

void write_hits(const EdgeCrossings& planned, HitWriter& writer) {
  const std::vector<LatticeBox> boxes = cell_boxes(writer.grid());
  const Marks open = find_open_gaps(writer.grid(), boxes, planned);
  for_each_splitting_edge(writer.grid(), boxes, [&](const SplittingEdge& edge) {
    for (Index c = planned.edge_begin[edge.number]; c < planned.edge_begin[edge.number + 1]; ++c) {
      const ClassifiedCrossing& crossing = planned.all[c];
      if (crossing.kept() || (!open.empty() && open.test(c))) writer.add(edge, crossing);
    }
    writer.end_edge(edge);
  });
}

}  // namespace kdm
