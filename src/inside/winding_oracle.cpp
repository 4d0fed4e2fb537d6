// SPDX-License-Identifier: MIT
// Finds the states of grid vertices by a field, and makes hits that fit these states.
#include "inside/winding_oracle.h"

#include <algorithm>
#include <utility>

#include "grid/faces.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

// Returns how exactly invented hits are placed, in lattice units: a sixteenth of the tolerance, but
// no finer than a sixteenth of a lattice unit, for rounding moves the surface by more.
double precision_for(double tolerance) { return std::max(1.0, tolerance) / 16; }

bool on_root_side(const LatticePoint& p) {
  return std::any_of(p.begin(), p.end(),
                     [](std::int32_t x) { return x == 0 || x == kLatticeSize; });
}

// Puts three coordinates, which take 21 bits each, into one number.
std::uint64_t pack(std::int32_t a, std::int32_t b, std::int32_t c) {
  return static_cast<std::uint64_t>(a) << 42 | static_cast<std::uint64_t>(b) << 21 |
         static_cast<std::uint64_t>(c);
}
// Returns one of the coordinates; 0 is the last one.
std::int32_t unpack(std::uint64_t packed, int i) {
  return static_cast<std::int32_t>(packed >> 21 * i & ((1u << 21) - 1));
}

}  // namespace

// All grid vertices, sorted by the grid lines that they lie on.
struct WindingOracle::GridVertices {
  // Per axis, ascending. A number holds the line's coordinates along the next and the previous
  // axis, the vertex's position along the line and, in its last bit, the vertex's state.
  std::array<std::vector<std::uint64_t>, 3> lines;
};

WindingOracle::WindingOracle(const Surface& surface, std::shared_ptr<const PointField> field,
                             double tolerance)
    : surface_(surface), field_(std::move(field)), resolver_(*field_, precision_for(tolerance)) {}

int WindingOracle::state_at(const LatticePoint& vertex, int counted) {
  static_cast<void>(counted);
  return inside(vertex) ? 1 : 0;
}

bool WindingOracle::inside(const LatticePoint& vertex) {
  if (on_root_side(vertex)) return false;
  const auto [entry, is_new] =
      known_states_.try_emplace(pack(vertex[0], vertex[1], vertex[2]), false);
  if (is_new) entry->second = field_->inside(vertex);
  return entry->second;
}

void WindingOracle::plan_edge(const GridEdge& edge, std::vector<Crossing>& found,
                              std::vector<ClassifiedCrossing>& planned) {
  const Segment segment{edge.axis, edge.low, edge.high, edge.state_low != 0, edge.state_high != 0};
  resolver_.resolve(segment, found, false, planned);
}

void WindingOracle::finish_edges(const EdgeCrossings& planned, HitWriter& writer) {
  const std::vector<LatticeBox> boxes = cell_boxes(writer.grid());
  const GridVertices vertices = find_vertices(writer.grid(), boxes);
  for_each_splitting_edge(writer.grid(), boxes, [&](const SplittingEdge& edge) {
    finish_edge(edge, vertices, planned.of(edge.number), writer);
    writer.end_edge(edge);
  });
}

// The corners of all minimal faces.
WindingOracle::GridVertices WindingOracle::find_vertices(const GridData& grid,
                                                         const std::vector<LatticeBox>& boxes) {
  std::vector<std::uint64_t> points;
  for_each_face_or_empty(grid, boxes, [&](const MinimalFace& face) {
    for_each_corner(face, [&](const LatticePoint& p) { points.push_back(pack(p[0], p[1], p[2])); });
  });
  sort_numbers(points);
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
  for (std::vector<std::uint64_t>& line : result.lines) sort_numbers(line);
  return result;
}

// Grid vertices of other cells cut the edge into segments, which are resolved one by one: where
// edges coincide, so do their hits.
void WindingOracle::finish_edge(const SplittingEdge& edge, const GridVertices& vertices,
                                std::span<const ClassifiedCrossing> planned, HitWriter& writer) {
  const LatticePoint low = edge.low();
  const LatticePoint high = edge.high();
  const int axis = edge.axis;
  const std::vector<std::uint64_t>& line = vertices.lines[axis];
  const auto key = [&](std::int32_t position) {
    return pack(low[next_axis(axis)], low[previous_axis(axis)], position) << 1;
  };
  auto vertex = std::lower_bound(line.begin(), line.end(), key(low[axis] + 1));
  Segment segment{axis, low, high[axis], inside(low), false};
  const bool inside_high = inside(high);
  std::size_t next = 0;
  for (bool last = false; !last;) {
    last = vertex == line.end() || *vertex >= key(high[axis]);
    segment.high = last ? high[axis] : unpack(*vertex >> 1, 0);
    segment.inside_high = last ? inside_high : (*vertex & 1) != 0;
    crossings_.clear();
    while (next < planned.size() && floor_of(planned[next].position()) < segment.high) {
      const TriangleId triangle = planned[next].triangle();
      crossings_.push_back(
          {planned[next].position(), triangle, points_up(surface_.triangles[triangle], axis)});
      ++next;
    }
    write_segment(edge, segment, writer);
    segment.low[axis] = segment.high;
    segment.inside_low = segment.inside_high;
    if (!last) ++vertex;
  }
}

// Makes hits of the crossings at hand.
void WindingOracle::write_segment(const SplittingEdge& edge, const Segment& segment,
                                  HitWriter& writer) {
  classified_.clear();
  resolver_.resolve(segment, crossings_, true, classified_);
  for (const ClassifiedCrossing& c : classified_) {
    if (!c.kept()) continue;
    if (c.triangle() == kNone) {
      writer.add_invented(edge, c.position(), c.leaving(), invented_plane(segment, c));
    } else {
      writer.add(edge, c);
    }
  }
}

// Returns the plane through the crossing in whose directions the field does not change.
Plane WindingOracle::invented_plane(const Segment& segment,
                                    const ClassifiedCrossing& invented) const {
  const double up = invented.leaving() ? 1 : -1;
  Vec3 point = to_vec3(segment.low);
  point[segment.axis] = real_position(invented.position());
  Vec3 normal = -field_->gradient(point);
  // Where the gradient is nearly normal to the edge or runs against the crossing's direction, the
  // plane is taken normal to the edge.
  constexpr double kLeastCosine = 0.05;
  if (!(up * normal[segment.axis] > kLeastCosine * normal.norm())) {
    normal = Vec3::Zero();
    normal[segment.axis] = up;
  }
  normal.normalize();
  return {normal, normal.dot(point)};
}

}  // namespace kdm
