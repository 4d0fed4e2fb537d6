// SPDX-License-Identifier: MIT
// Finds the states of grid vertices by a field, and makes hits that fit these states.
#include "inside/winding_oracle.h"

#include <algorithm>
#include <utility>

#include "grid/faces.h"
#include "mesh/sort.h"
#include "threads/share_work.h"

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

// A hit that is to be written.
struct WindingOracle::EdgeHit {
  ClassifiedCrossing crossing;
  Plane plane;  // if it is invented
};

WindingOracle::WindingOracle(const Surface& surface, std::shared_ptr<const PointField> field,
                             double tolerance)
    : surface_(surface), field_(std::move(field)), resolver_(*field_, precision_for(tolerance)) {}

WindingOracle::WindingOracle(const WindingOracle& other, std::shared_ptr<const PointField> field)
    : surface_(other.surface_),
      field_(std::move(field)),
      resolver_(*field_, other.resolver_.precision()),
      work_before_(field_->work()) {}

std::unique_ptr<InsideModel> WindingOracle::fork() const { return fork_oracle(); }

std::unique_ptr<WindingOracle> WindingOracle::fork_oracle() const {
  if constexpr (!kHasThreads) return nullptr;
  std::shared_ptr<const PointField> field = field_->fork();
  if (!field) return nullptr;
  return std::unique_ptr<WindingOracle>(new WindingOracle(*this, std::move(field)));
}

void WindingOracle::join(InsideModel& fork) {
  if constexpr (!kHasThreads) return;
  auto& oracle = static_cast<WindingOracle&>(fork);
  known_states_.merge(oracle.known_states_);
  joined_work_ += oracle.work() - oracle.work_before_;
}

// Calls ask(oracle, first, end) for ranges of numbers below `count`, on several threads if the
// field can be asked by several.
template <typename Ask>
void WindingOracle::share(std::size_t count, const Ask& ask) {
  if constexpr (!kHasThreads) return ask(*this, 0, count);
  constexpr std::size_t kNumbersPerPart = 512;
  const std::size_t parts = count / kNumbersPerPart + 1;
  // A fork copies what the field remembers, which is worth it for many numbers only.
  constexpr std::size_t kPartsPerThread = 4;
  const std::size_t threads =
      std::min(static_cast<std::size_t>(workers()), parts / kPartsPerThread + 1);
  std::vector<std::unique_ptr<WindingOracle>> forks;  // for all threads but this one
  while (forks.size() + 1 < threads) {
    forks.push_back(fork_oracle());
    if (!forks.back()) return ask(*this, 0, count);
  }
  share_work(parts, static_cast<int>(threads), [&](std::size_t part, int worker) {
    WindingOracle& oracle = worker == 0 ? *this : *forks[static_cast<std::size_t>(worker) - 1];
    ask(oracle, begin_of_part(count, part, parts), begin_of_part(count, part + 1, parts));
  });
  for (const std::unique_ptr<WindingOracle>& fork : forks) join(*fork);
}

int WindingOracle::state_at(const LatticePoint& vertex, int counted) {
  static_cast<void>(counted);
  const auto [known, is_new] =
      known_states_.try_emplace(pack(vertex[0], vertex[1], vertex[2]), false);
  if (is_new) known->second = find_state(vertex);
  return known->second ? 1 : 0;
}

bool WindingOracle::find_state(const LatticePoint& vertex) const {
  return !on_root_side(vertex) && field_->inside(vertex);
}

void WindingOracle::plan_edge(const GridEdge& edge, std::vector<Crossing>& found,
                              std::vector<ClassifiedCrossing>& planned) {
  const Segment segment{edge.axis, edge.low, edge.high, edge.state_low != 0, edge.state_high != 0};
  resolver_.resolve(segment, found, false, planned);
}

void WindingOracle::finish_edges(const EdgeCrossings& planned, HitWriter& writer) {
  const std::vector<LatticeBox> boxes = cell_boxes(writer.grid());
  const GridVertices vertices = find_vertices(writer.grid(), boxes);
  std::vector<SplittingEdge> edges;
  edges.reserve(4 * std::size_t{writer.grid().splits()});
  for_each_splitting_edge(writer.grid(), boxes,
                          [&](const SplittingEdge& edge) { edges.push_back(edge); });
  std::vector<std::vector<EdgeHit>> hits(edges.size());
  share(edges.size(), [&](WindingOracle& oracle, std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      oracle.finish_edge(edges[i], vertices, planned.of(edges[i].number), hits[i]);
    }
  });
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (const EdgeHit& hit : hits[i]) {
      const ClassifiedCrossing& c = hit.crossing;
      if (c.triangle() == kNone) {
        writer.add_invented(edges[i], c.position(), c.leaving(), hit.plane);
      } else {
        writer.add(edges[i], c);
      }
    }
    writer.end_edge(edges[i]);
  }
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
  for (std::vector<std::uint64_t>& line : result.lines) line.resize(points.size());
  share(points.size(), [&](WindingOracle& oracle, std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      const LatticePoint p{unpack(points[i], 2), unpack(points[i], 1), unpack(points[i], 0)};
      const auto known = known_states_.find(points[i]);
      const bool inside = known != known_states_.end() ? known->second : oracle.find_state(p);
      for (int axis = 0; axis < 3; ++axis) {
        result.lines[axis][i] =
            pack(p[next_axis(axis)], p[previous_axis(axis)], p[axis]) << 1 | (inside ? 1 : 0);
      }
    }
  });
  for (std::vector<std::uint64_t>& line : result.lines) sort_numbers(line);
  return result;
}

// Grid vertices of other cells cut the edge into segments, which are resolved one by one: where
// edges coincide, so do their hits.
void WindingOracle::finish_edge(const SplittingEdge& edge, const GridVertices& vertices,
                                std::span<const ClassifiedCrossing> planned,
                                std::vector<EdgeHit>& hits) {
  const LatticePoint low = edge.low();
  const LatticePoint high = edge.high();
  const int axis = edge.axis;
  const std::vector<std::uint64_t>& line = vertices.lines[axis];
  const auto key = [&](std::int32_t position) {
    return pack(low[next_axis(axis)], low[previous_axis(axis)], position) << 1;
  };
  // Both ends are corners of minimal faces.
  auto vertex = std::lower_bound(line.begin(), line.end(), key(low[axis]));
  Segment segment{axis, low, low[axis], false, (*vertex & 1) != 0};
  std::size_t next = 0;
  while (segment.high < high[axis]) {
    segment.low[axis] = segment.high;
    segment.inside_low = segment.inside_high;
    ++vertex;
    segment.high = unpack(*vertex >> 1, 0);
    segment.inside_high = (*vertex & 1) != 0;
    crossings_.clear();
    while (next < planned.size() && floor_of(planned[next].position()) < segment.high) {
      const TriangleId triangle = planned[next].triangle();
      crossings_.push_back(
          {planned[next].position(), triangle, points_up(surface_.triangles[triangle], axis)});
      ++next;
    }
    finish_segment(segment, hits);
  }
}

// Makes hits of the crossings at hand.
void WindingOracle::finish_segment(const Segment& segment, std::vector<EdgeHit>& hits) {
  classified_.clear();
  resolver_.resolve(segment, crossings_, true, classified_);
  for (const ClassifiedCrossing& c : classified_) {
    if (!c.kept()) continue;
    hits.push_back({c, c.triangle() == kNone ? invented_plane(segment, c) : Plane()});
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
