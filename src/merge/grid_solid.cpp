// SPDX-License-Identifier: MIT
#include "merge/grid_solid.h"

#include "grid/faces.h"
#include "grid/splitting_edges.h"
#include "merge/corner_signs.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

// Counts the leaves that a plane cuts; see GridSolid::count_cut.
class CutCount {
 public:
  CutCount(const GridSolid& solid, const LatticeBox& within, int axis, std::int32_t value)
      : solid_(solid), within_(within), axis_(axis), value_(value) {}

  Index in(CellId cell) const {
    if (!solid_.has_surface(cell)) return 0;
    const LatticeBox& box = solid_.boxes()[cell];
    if (value_ <= box.lo[axis_] || value_ >= box.hi[axis_]) return 0;
    for (int i = 0; i < 3; ++i) {
      if (box.hi[i] <= within_.lo[i] || box.lo[i] >= within_.hi[i]) return 0;
    }
    const Cell& split = solid_.grid().cells[cell];
    return split.leaf() ? 1 : in(split.below()) + in(split.above());
  }

 private:
  const GridSolid& solid_;
  const LatticeBox& within_;
  int axis_;
  std::int32_t value_;
};

}  // namespace

GridSolid::GridSolid(const GridData& grid)
    : grid_(grid),
      boxes_(cell_boxes(grid)),
      signs_(corner_signs(grid)),
      edge_signs_(4 * std::size_t{grid.splits()}, 0),
      surface_(span_surface(grid, boxes_)),
      triangles_begin_(grid.cells.size() + 1, 0),
      triangles_of_(surface_.corners.size()),
      triangle_of_hit_(grid.hits.size(), kNone),
      has_surface_(grid.cells.size(), 0) {
  for (const Cell& split : grid.cells) {
    if (split.leaf()) continue;
    const int u = 1 << next_axis(split.axis());
    const int v = 1 << previous_axis(split.axis());
    // The corner of the upper half at the low end of each edge.
    const std::array<int, 4> low_corner{0, u, v, 0};
    for (int i = 0; i < 4; ++i) {
      edge_signs_[edge_of_split(split.split(), i)] = signs_[split.above()] >> low_corner[i] & 1;
    }
  }
  for (const CellId leaf : surface_.leaf) ++triangles_begin_[leaf + 1];
  for (std::size_t c = 0; c < grid.cells.size(); ++c)
    triangles_begin_[c + 1] += triangles_begin_[c];
  std::vector<Index> next(triangles_begin_.begin(), triangles_begin_.end() - 1);
  for (Index t = 0; t < surface_.leaf.size(); ++t) {
    triangles_of_[next[surface_.leaf[t]]++] = t;
  }
  find_triangles_of_hits();
  for (const CellId leaf : surface_.leaf) has_surface_[leaf] = 1;
  for (std::size_t c = grid.cells.size(); c-- > 0;) {
    const Cell& split = grid.cells[c];
    if (split.leaf()) continue;
    has_surface_[c] = static_cast<char>(has_surface_[split.below()] | has_surface_[split.above()]);
  }
}

// Finds for each hit the triangle that its grid edge crosses, once it is shifted: one of those
// round the hit's point. If rounding leaves none, it is any of them.
void GridSolid::find_triangles_of_hits() {
  const std::size_t points = surface_.points.size();
  std::vector<Index> begin(points + 1, 0);
  for (const Triangle& t : surface_.corners) ++begin[t[SpannedSurface::kHit] + 1];
  for (std::size_t p = 0; p < points; ++p) begin[p + 1] += begin[p];
  std::vector<Index> round(surface_.corners.size());
  std::vector<Index> next(begin.begin(), begin.end() - 1);
  for (Index t = 0; t < surface_.corners.size(); ++t) {
    round[next[surface_.corners[t][SpannedSurface::kHit]]++] = t;
  }
  for_each_splitting_edge(grid_, boxes_, [&](const SplittingEdge& edge) {
    const LatticePoint low = edge.low();
    for (const HitId h : edge.hits) {
      const PointId point = surface_.point_of_hit[h];
      for (Index i = begin[point]; i < begin[point + 1]; ++i) {
        const int turn = line_crosses(triangle(round[i]), edge.axis, low[next_axis(edge.axis)],
                                      low[previous_axis(edge.axis)]);
        const bool crosses = turn != 0 && (turn > 0) == grid_.hits[h].leaving();
        if (crosses || triangle_of_hit_[h] == kNone) triangle_of_hit_[h] = round[i];
        if (crosses) break;
      }
    }
  });
}

std::span<const Index> GridSolid::triangles_in(CellId leaf) const {
  const Index begin = triangles_begin_[leaf];
  return {triangles_of_.data() + begin, triangles_begin_[leaf + 1] - begin};
}

LatticeTriangle GridSolid::triangle(Index number) const {
  const Triangle& t = surface_.corners[number];
  return {surface_.points[t[0]], surface_.points[t[1]], surface_.points[t[2]]};
}

// Tells whether an edge is inside at a lattice coordinate along it.
bool GridSolid::inside_on_edge(EdgeId edge, std::int32_t at) const {
  const HitRange hits = grid_.edge_hits(edge);
  const Index below = first_above(grid_.hits, hits, at) - hits.first;
  return (edge_signs_[edge] != 0) != (below % 2 != 0);
}

bool GridSolid::inside(const LatticePoint& point) const {
  bool on_edge = false;
  bool inside = false;
  for (int axis = 0; axis < 3 && !on_edge; ++axis) {
    for_each_stretch(grid_, boxes_, axis, point, point[axis], point[axis],
                     [&](const LineStretch& stretch) {
                       if (!stretch.on_edge()) return;
                       on_edge = true;
                       inside = inside_on_edge(stretch.edge, point[axis]);
                     });
  }
  return on_edge ? inside : inside_by_surface(point);
}

// Follows a line down from the point through the leaves in which it runs once it is shifted, to one
// without surface. So the answers for all points in a leaf fit each other.
bool GridSolid::inside_by_surface(const LatticePoint& point) const {
  LatticePoint at = point;
  bool turned = false;
  bool first = true;
  std::vector<SolidCrossing> found;
  while (first || at[0] > 0) {
    CellId cell = 0;
    while (!grid_.cells[cell].leaf()) {
      const Cell& split = grid_.cells[cell];
      const bool upper =
          split.axis() == 0 && !first ? at[0] > split.value() : at[split.axis()] >= split.value();
      cell = upper ? split.above() : split.below();
    }
    first = false;
    if (!has_surface(cell)) return ((signs_[cell] & 1) != 0) != turned;
    const std::int32_t low = boxes_[cell].lo[0];
    found.clear();
    cross_leaf(cell, 0, point, low, at[0], found);
    if (found.size() % 2 != 0) turned = !turned;
    at[0] = low;
  }
  return turned;
}

void GridSolid::cross_leaf(CellId leaf, int axis, const LatticePoint& on_line, std::int32_t low,
                           std::int32_t high, std::vector<SolidCrossing>& found) const {
  const std::int32_t u = on_line[next_axis(axis)];
  const std::int32_t v = on_line[previous_axis(axis)];
  for (const Index t : triangles_in(leaf)) {
    const LatticeTriangle corners = triangle(t);
    const int turn = line_crosses(corners, axis, u, v);
    if (turn == 0) continue;
    const LinePosition position = crossing_position(corners, axis, u, v);
    if (floor_of(position) < low || floor_of(position) >= high) continue;
    found.push_back({position, t, turn > 0});
  }
}

void GridSolid::find_crossings(int axis, const LatticePoint& on_line, std::int32_t low,
                               std::int32_t high, std::vector<SolidCrossing>& found) const {
  const std::size_t first = found.size();
  for_each_stretch(grid_, boxes_, axis, on_line, low, high, [&](const LineStretch& stretch) {
    if (!stretch.on_edge()) {
      cross_leaf(stretch.leaf, axis, on_line, stretch.low, stretch.high, found);
      return;
    }
    HitRange hits = grid_.edge_hits(stretch.edge);
    hits.first = first_above(grid_.hits, hits, stretch.low);
    hits.beyond = first_above(grid_.hits, hits, stretch.high);
    for (const HitId h : hits) {
      found.push_back({grid_.hits[h].position, triangle_of_hit_[h], grid_.hits[h].leaving()});
    }
  });
  sort_by(std::span(found).subspan(first), [](const SolidCrossing& a, const SolidCrossing& b) {
    return a.position != b.position ? a.position < b.position : a.triangle < b.triangle;
  });
}

HitId GridSolid::hit_beside(const LatticePoint& point, std::int32_t distance) const {
  HitId beside = kNone;
  std::int32_t nearest = distance + 1;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int32_t low = std::max(point[axis] - distance, 0);
    const std::int32_t high = std::min(point[axis] + distance, kLatticeSize);
    for_each_stretch(grid_, boxes_, axis, point, low, high, [&](const LineStretch& stretch) {
      if (!stretch.on_edge()) return;
      for (const HitId h : grid_.edge_hits(stretch.edge)) {
        const std::int32_t off = std::abs(floor_of(grid_.hits[h].position) - point[axis]);
        if (off >= nearest) continue;
        nearest = off;
        beside = h;
      }
    });
  }
  return beside;
}

Index GridSolid::count_cut(CellId cell, const LatticeBox& box, int axis, std::int32_t value) const {
  return CutCount(*this, box, axis, value).in(cell);
}

}  // namespace kdm
