// SPDX-License-Identifier: MIT
#include "inside/gaps.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "grid/faces.h"
#include "grid/splitting_edges.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

// Within one part, lattice units: what rounding does to two faces that lie on each other.
constexpr double kNarrow = 4;

// Of a gap on a grid line: the line, the lattice planes that the gap reaches across, and the first
// of its two crossings.
struct Gap {
  std::uint64_t line;  // axis and the two coordinates across it
  std::int32_t first;  // the first and the last lattice plane in the gap
  std::int32_t last;
  Index crossing;
};

std::uint64_t line_of(const LatticePoint& p, int axis) {
  return static_cast<std::uint64_t>(axis) << 60 |
         static_cast<std::uint64_t>(p[next_axis(axis)]) << 30 |
         static_cast<std::uint64_t>(p[previous_axis(axis)]);
}

// Returns the gaps in which a grid vertex may lie, sorted by their lines.
std::vector<Gap> find_gaps(const GridData& grid, const std::vector<LatticeBox>& boxes,
                           const EdgeCrossings& planned) {
  std::vector<Gap> gaps;
  const bool some = std::any_of(planned.all.begin(), planned.all.end(), [](const auto& crossing) {
    return crossing.role() == CrossingRole::kGap;
  });
  if (!some) return gaps;
  for_each_splitting_edge(grid, boxes, [&](const SplittingEdge& edge) {
    const Index end = planned.edge_begin[edge.number + 1];
    for (Index c = planned.edge_begin[edge.number]; c < end; ++c) {
      if (planned.all[c].role() != CrossingRole::kGap || !planned.all[c].leaving()) continue;
      const Index other = end_of_gap(planned.all, c);
      // A crossing lies above the plane of its floor.
      const std::int32_t first = floor_of(planned.all[c].position()) + 1;
      const std::int32_t last = floor_of(planned.all[other].position());
      if (first <= last) gaps.push_back({line_of(edge.low(), edge.axis), first, last, c});
    }
  });
  sort_by(gaps, [](const Gap& a, const Gap& b) {
    return a.line != b.line ? a.line < b.line : a.first < b.first;
  });
  return gaps;
}

}  // namespace

GapRule::GapRule(const Surface& surface, double tolerance)
    : surface_(surface), part_of_(find_parts(surface.topology)), widest_(widest_gap(tolerance)) {}

void GapRule::close(int axis, std::span<ClassifiedCrossing> edge) const {
  ClassifiedCrossing* leaving = nullptr;  // where the solid was left last
  for (ClassifiedCrossing& crossing : edge) {
    if (!crossing.kept()) continue;
    if (crossing.leaving()) {
      leaving = &crossing;
    } else if (leaving != nullptr && closes(axis, *leaving, crossing)) {
      leaving->set_role(CrossingRole::kGap);
      crossing.set_role(CrossingRole::kGap);
    }
  }
}

bool GapRule::closes(int axis, const ClassifiedCrossing& leaving,
                     const ClassifiedCrossing& entering) const {
  constexpr double kFacing = -0.9;  // the normals' cosine
  const Vec3& normal = surface_.planes[leaving.triangle()].normal;
  if (normal.dot(surface_.planes[entering.triangle()].normal) > kFacing) return false;
  // Across the gap, not along the edge, which may be nearly parallel to it.
  const double along = (entering.position() - leaving.position()) * kFractionUnit;
  const double width = along * std::abs(normal[axis]);
  const bool two_parts =
      !part_of_.empty() && part_of_[leaving.triangle()] != part_of_[entering.triangle()];
  return width <= (two_parts ? widest_ : kNarrow);
}

Marks find_open_gaps(const GridData& grid, const std::vector<LatticeBox>& boxes,
                     const EdgeCrossings& planned) {
  Marks open;
  const std::vector<Gap> gaps = find_gaps(grid, boxes, planned);
  if (gaps.empty()) return open;
  const auto open_at = [&](const LatticePoint& vertex, int axis) {
    const std::uint64_t line = line_of(vertex, axis);
    auto gap = std::lower_bound(gaps.begin(), gaps.end(), line,
                                [](const Gap& g, std::uint64_t l) { return g.line < l; });
    for (; gap != gaps.end() && gap->line == line; ++gap) {
      if (gap->first > vertex[axis] || gap->last < vertex[axis]) continue;
      if (open.empty()) open.assign(planned.all.size());
      open.set(gap->crossing);
      open.set(end_of_gap(planned.all, gap->crossing));
    }
  };
  for_each_face_or_empty(grid, boxes, [&](const MinimalFace& face) {
    for_each_corner(face, [&](const LatticePoint& p) {
      for (int axis = 0; axis < 3; ++axis) open_at(p, axis);
    });
  });
  return open;
}

}  // namespace kdm
