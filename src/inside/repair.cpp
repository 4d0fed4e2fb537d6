// SPDX-License-Identifier: MIT
// Hits of surfaces whose crossings contradict each other.
#include "inside/repair.h"

#include <algorithm>

#include "grid/faces.h"

namespace kdm {
namespace {

constexpr double kFinestPrecision = 1.0 / 16;  // lattice units

double precision_for(double tolerance) { return std::max(kFinestPrecision, tolerance / 16); }

bool on_root_side(const LatticePoint& p) {
  return std::any_of(p.begin(), p.end(),
                     [](std::int32_t x) { return x == 0 || x == kLatticeSize; });
}

// Coordinates take 21 bits.
std::uint64_t pack(std::int32_t a, std::int32_t b, std::int32_t c) {
  return static_cast<std::uint64_t>(a) << 42 | static_cast<std::uint64_t>(b) << 21 |
         static_cast<std::uint64_t>(c);
}
std::int32_t unpack(std::uint64_t packed, int i) {
  return static_cast<std::int32_t>(packed >> 21 * i & ((1u << 21) - 1));
}

}  // namespace

// All grid vertices, by the lines they lie on.
struct Repair::GridVertices {
  // Per axis, ascending: the line's coordinates along the next and the previous axis, the position
  // along it, and whether that is inside.
  std::array<std::vector<std::uint64_t>, 3> lines;
};

Repair::Repair(Surface& surface, double threshold, double tolerance)
    : surface_(surface),
      field_(surface.triangles, threshold),
      resolver_(field_, precision_for(tolerance)) {}

bool Repair::inside(const LatticePoint& p) {
  if (on_root_side(p)) return false;
  const auto [entry, is_new] = known_.try_emplace(pack(p[0], p[1], p[2]), false);
  if (is_new) entry->second = field_.inside(p);
  return entry->second;
}

void Repair::resolve(GridData& grid) {
  const std::vector<LatticeBox> boxes = cell_boxes(grid);
  const GridVertices vertices = find_vertices(grid, boxes);
  std::vector<Index> cell_of(grid.splits());
  for (Index c = 0; c < grid.cells.size(); ++c) {
    if (!grid.cells[c].leaf()) cell_of[grid.cells[c].split()] = c;
  }
  std::vector<Hit> hits;
  hits.reserve(grid.hits.size());
  Index begin = 0;
  for (Index edge = 0; edge < 4 * grid.splits(); ++edge) {
    const Cell& cell = grid.cells[cell_of[edge / 4]];
    const LatticeBox& box = boxes[cell_of[edge / 4]];
    const int i = static_cast<int>(edge % 4);
    // Edges 1 and 2 end at the high ends of both axes.
    const LatticePoint low = corner_on_plane(box, cell.axis(), cell.value(), i == 1, i == 2);
    const LatticePoint high = corner_on_plane(box, cell.axis(), cell.value(), i != 3, i != 0);
    const int axis = axis_of_edge(cell.axis(), i);
    const Index end = grid.edge_begin[edge + 1];
    resolve_edge(vertices, {axis, low, high[axis], inside(low), inside(high)}, i,
                 std::span(grid.hits).subspan(begin, end - begin), hits);
    begin = end;
    grid.edge_begin[edge + 1] = static_cast<Index>(hits.size());
  }
  grid.hits = std::move(hits);
}

// The corners of all minimal faces.
Repair::GridVertices Repair::find_vertices(const GridData& grid,
                                           const std::vector<LatticeBox>& boxes) {
  std::vector<std::uint64_t> points;
  for_each_face_or_empty(grid, boxes, [&](const MinimalFace& face) {
    LatticePoint p;
    p[face.axis] = face.plane;
    for (const std::int32_t u : {face.lo(0), face.hi(0)}) {
      p[next_axis(face.axis)] = u;
      for (const std::int32_t v : {face.lo(1), face.hi(1)}) {
        p[previous_axis(face.axis)] = v;
        points.push_back(pack(p[0], p[1], p[2]));
      }
    }
  });
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  GridVertices result;
  for (std::vector<std::uint64_t>& line : result.lines) line.reserve(points.size());
  for (const std::uint64_t point : points) {
    const LatticePoint p{unpack(point, 2), unpack(point, 1), unpack(point, 0)};
    const std::uint64_t state = inside(p) ? 1 : 0;
    for (int axis = 0; axis < 3; ++axis) {
      result.lines[axis].push_back(pack(p[next_axis(axis)], p[previous_axis(axis)], p[axis]) << 1 |
                                   state);
    }
  }
  for (std::vector<std::uint64_t>& line : result.lines) std::sort(line.begin(), line.end());
  return result;
}

// Grid vertices of other cells cut the edge into segments, which are resolved one by one: where
// edges coincide, so do their hits.
void Repair::resolve_edge(const GridVertices& vertices, const Segment& edge, int number,
                          std::span<const Hit> crossings, std::vector<Hit>& hits) {
  const int axis = edge.axis;
  const std::vector<std::uint64_t>& line = vertices.lines[axis];
  const auto key = [&](std::int32_t position) {
    return pack(edge.low[next_axis(axis)], edge.low[previous_axis(axis)], position) << 1;
  };
  auto vertex = std::lower_bound(line.begin(), line.end(), key(edge.low[axis] + 1));
  Segment segment = edge;
  std::size_t next = 0;
  for (bool last = false; !last;) {
    last = vertex == line.end() || *vertex >= key(edge.high);
    segment.high = last ? edge.high : unpack(*vertex >> 1, 0);
    segment.inside_high = last ? edge.inside_high : (*vertex & 1) != 0;
    crossings_.clear();
    while (next < crossings.size() && floor_of(crossings[next].position) < segment.high) {
      const Index triangle = crossings[next].plane();
      crossings_.push_back(
          {crossings[next].position, triangle, points_up(surface_.triangles[triangle], axis)});
      ++next;
    }
    resolver_.resolve(segment, crossings_, true, walked_);
    for (const WalkedCrossing& c : walked_) {
      if (!c.kept) continue;
      const Index plane =
          c.crossing.triangle == kNone ? invented_plane(segment, c) : c.crossing.triangle;
      hits.push_back(
          Hit(c.crossing.position, plane, c.leaving, reversed_on_edge(number, c.leaving)));
    }
    segment.low[axis] = segment.high;
    segment.inside_low = segment.inside_high;
    if (!last) ++vertex;
  }
}

Index Repair::invented_plane(const Segment& segment, const WalkedCrossing& invented) {
  const double up = invented.leaving ? 1 : -1;
  Vec3 point = to_vec3(segment.low);
  point[segment.axis] = real_position(invented.crossing.position);
  Vec3 normal = -field_.gradient(point);
  // Where the field says nothing, or the contrary, the edge is all that is known.
  constexpr double kLeastCosine = 0.05;
  if (!(up * normal[segment.axis] > kLeastCosine * normal.norm())) {
    normal = Vec3::Zero();
    normal[segment.axis] = up;
  }
  normal.normalize();
  surface_.planes.push_back({normal, normal.dot(point)});
  surface_.source_faces.push_back(kNone);
  return static_cast<Index>(surface_.planes.size() - 1);
}

}  // namespace kdm
