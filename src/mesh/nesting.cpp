// SPDX-License-Identifier: MIT
// Finds winding numbers by rays: a part's winding number at a point is a sum over the triangles
// that a ray from the point down the x axis meets. The point is read as shifted by (0, e, e^2),
// where e is infinitesimal, so that no ray meets an edge.
#include "mesh/nesting.h"

#include <algorithm>
#include <array>

#include "geometry/distance.h"
#include "geometry/exact_sign.h"
#include "mesh/box_tree.h"
#include "mesh/boxes.h"
#include "mesh/groups.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

using Corners = std::array<Vec3, 3>;

// Limits the work to about a second. It is counted in pairs of boxes that meet; to compare a point
// with a triangle counts as several. Six thousand parts that all overlap reach the limit, or two
// thousand round each other, but not a block with a hundred thousand bubbles.
constexpr std::uint64_t kMostTests = std::uint64_t{1} << 25;
constexpr std::uint64_t kTestsPerPoint = 4;

// A point this close to a part lies on it: parts that touch do so but for rounding errors.
constexpr double kTouching = 1e-7;

Box widened(const Box& box) { return {box.min.array() - kTouching, box.max.array() + kTouching}; }

bool holds(const Box& a, const Box& b) {
  return (a.min.array() <= b.min.array()).all() && (a.max.array() >= b.max.array()).all();
}

// Returns for each closed part its vertices furthest out along the eight diagonals of space, each
// once. Of a box they are all corners; so some are left to judge by if others touch the outer part.
std::vector<std::vector<Index>> take_samples(const Polygons& faces, std::span<const Vec3> positions,
                                             std::span<const Index> part_of,
                                             std::span<const Shell> shells) {
  struct Furthest {
    std::array<Index, 8> vertices = {kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone};
    std::array<double, 8> distances = {};
  };
  std::vector<Furthest> furthest(shells.size());
  std::vector<Index> last_part(positions.size(), kNone);  // that was seen to have the vertex
  for (Index face = 0; face < faces.size(); ++face) {
    if (part_of[face] == kNone || !shells[part_of[face]].closed) continue;
    Furthest& found = furthest[part_of[face]];
    for (Index k = 0; k < faces.corners(face); ++k) {
      const Index v = faces[face][k];
      if (last_part[v] == part_of[face]) continue;
      last_part[v] = part_of[face];
      const Vec3& p = positions[v];
      for (std::size_t i = 0; i < 8; ++i) {
        const double distance = ((i & 1) != 0 ? p.x() : -p.x()) + ((i & 2) != 0 ? p.y() : -p.y()) +
                                ((i & 4) != 0 ? p.z() : -p.z());
        if (found.vertices[i] != kNone && distance <= found.distances[i]) continue;
        found.vertices[i] = v;
        found.distances[i] = distance;
      }
    }
  }
  std::vector<std::vector<Index>> samples(shells.size());
  for (Index part = 0; part < shells.size(); ++part) {
    if (!shells[part].closed) continue;
    std::array<Index, 8>& found = furthest[part].vertices;
    sort_numbers(found);
    samples[part].assign(found.begin(), std::unique(found.begin(), found.end()));
  }
  return samples;
}

Groups faces_by_part(std::span<const Index> part_of, std::size_t parts) {
  return Groups(parts, [&](const auto& put) {
    for (Index face = 0; face < part_of.size(); ++face) {
      if (part_of[face] != kNone) put(part_of[face], face);
    }
  });
}

int sign(double x) { return x > 0 ? 1 : (x < 0 ? -1 : 0); }

// Returns on which side of the edge from a to b the shifted point p is, seen along x.
int side_of_edge(const Vec3& a, const Vec3& b, const Vec3& p) {
  const int area = area_sign(a, b, p, 0);
  if (area != 0) return area;
  return a.z() != b.z() ? sign(a.z() - b.z()) : sign(b.y() - a.y());
}

// Returns 0 if the line along x through the shifted point misses the triangle, else the sign of the
// triangle's normal along x.
int line_crosses(const Corners& t, const Vec3& p) {
  const int first = side_of_edge(t[0], t[1], p);
  if (first == 0 || side_of_edge(t[1], t[2], p) != first) return 0;
  return side_of_edge(t[2], t[0], p) == first ? first : 0;
}

// `box` is that of the triangle, widened.
bool is_on(const Corners& t, const Box& box, const Vec3& p) {
  return holds(box, {p, p}) && squared_distance(p, t[0], t[1], t[2]) <= kTouching * kTouching;
}

// Calls `ask(corners)` for every triangle of some faces.
template <typename Ask>
void for_each_corners(const Polygons& faces, std::span<const Vec3> positions,
                      std::span<const Index> some, const Ask& ask) {
  for (const Index face : some) {
    faces.for_each_triangle_of(face, [&](const Triangle& t) {
      ask(Corners{positions[t[0]], positions[t[1]], positions[t[2]]});
    });
  }
}

// Returns points amid some of the faces, eight at most, spread evenly over the list, as boxes.
std::vector<Box> middles(const Polygons& faces, std::span<const Vec3> positions,
                         std::span<const Index> some) {
  const std::size_t step = (some.size() + 7) / 8;
  std::vector<Box> points;
  for (std::size_t i = step / 2; i < some.size(); i += step) {
    const Index* v = faces[some[i]];
    const Vec3 middle = (positions[v[0]] + positions[v[1]] + positions[v[2]]) / 3;
    points.push_back({middle, middle});
  }
  return points;
}

// Where a point lies in relation to one part.
struct Verdict {
  int winding = 0;  // the part's winding number at the point
  bool on = false;  // the point is on the part; then the winding number does not count
};

// Tells whether the triangle lies beside or above all rays from points within the bounds, which are
// widened.
bool misses_rays(const Corners& t, const Box& bounds) {
  for (const int axis : {1, 2}) {
    const auto [low, high] = std::minmax({t[0][axis], t[1][axis], t[2][axis]});
    if (low > bounds.max[axis] || high < bounds.min[axis]) return true;
  }
  return std::min({t[0].x(), t[1].x(), t[2].x()}) > bounds.max.x();
}

// Finds where points lie in relation to one part, whose triangles `triangles(ask)` passes to `ask`
// one by one. The points are given as boxes. Adds the work to `tests`; when that is too much, the
// rest of the triangles is left out.
template <typename Triangles>
std::vector<Verdict> judge(const std::vector<Box>& points, const Triangles& triangles,
                           std::uint64_t& tests) {
  Box bounds = points[0];
  for (const Box& point : points) grow(bounds, point);
  bounds = widened(bounds);
  const double highest = bounds.max.x();
  const BoxTree tree(points);
  std::vector<Verdict> verdicts(points.size());
  triangles([&](const Corners& t) {
    if (tests > kMostTests || misses_rays(t, bounds)) return;
    const Box box = widened(box_of(t[0], t[1], t[2]));
    Box above = box;
    above.max.x() = std::max(above.max.x(), highest);
    tree.for_each_meeting(above, [&](Index i) {
      tests += kTestsPerPoint;
      const Vec3& p = points[i].min;
      if (verdicts[i].on) return;
      verdicts[i].on = is_on(t, box, p);
      const int side = volume_sign(t[0], t[1], t[2], p);
      // The triangle is below the point if its normal points up the axis and the point is on the
      // side that it points to, or neither. Then a line up the axis leaves or enters the part
      // there.
      const int up = line_crosses(t, p);
      if (side != 0 && up == side) verdicts[i].winding -= up;
    });
  });
  return verdicts;
}

}  // namespace

std::optional<std::vector<Enclosure>> find_enclosures(const Polygons& faces,
                                                      std::span<const Vec3> positions,
                                                      std::span<const Index> part_of,
                                                      std::span<const Shell> shells) {
  std::vector<Index> closed;
  std::vector<Box> boxes;
  for (Index part = 0; part < shells.size(); ++part) {
    if (!shells[part].closed) continue;
    closed.push_back(part);
    boxes.push_back(shells[part].bounds);
  }
  std::vector<Enclosure> enclosures;
  if (closed.size() < 2) return enclosures;
  const BoxTree tree(boxes);
  const std::vector<std::vector<Index>> samples = take_samples(faces, positions, part_of, shells);
  const Groups faces_of = faces_by_part(part_of, shells.size());

  std::uint64_t tests = 0;
  for (const Index outer : closed) {
    std::vector<Index> candidates;
    std::vector<Box> points;
    const Box bounds = widened(shells[outer].bounds);
    tree.for_each_meeting(bounds, [&](Index i) {
      ++tests;
      if (closed[i] == outer || !holds(bounds, boxes[i])) return;
      candidates.push_back(closed[i]);
      for (const Index v : samples[closed[i]]) points.push_back({positions[v], positions[v]});
    });
    if (tests > kMostTests) return std::nullopt;
    if (candidates.empty()) continue;
    const auto triangles_of_outer = [&](const auto& ask) {
      for_each_corners(faces, positions, faces_of.of(outer), ask);
    };
    const std::vector<Verdict> verdicts = judge(points, triangles_of_outer, tests);
    if (tests > kMostTests) return std::nullopt;
    auto verdict = verdicts.begin();
    for (const Index inner : candidates) {
      const auto end = verdict + static_cast<std::ptrdiff_t>(samples[inner].size());
      const bool none_outside =
          std::all_of(verdict, end, [](const Verdict& v) { return v.on || v.winding != 0; });
      const bool one_inside = std::any_of(verdict, end, [](const Verdict& v) { return !v.on; });
      verdict = end;
      if (!none_outside) continue;
      if (one_inside) {
        enclosures.push_back({inner, outer});
        continue;
      }
      // All of its outermost vertices lie on the other part: amid its faces it may not.
      const std::vector<Verdict> amid =
          judge(middles(faces, positions, faces_of.of(inner)), triangles_of_outer, tests);
      std::size_t within = 0;
      std::size_t outside = 0;
      for (const Verdict& v : amid) {
        if (!v.on) ++(v.winding != 0 ? within : outside);
      }
      if (within > outside) enclosures.push_back({inner, outer});
    }
    if (tests > kMostTests) return std::nullopt;
  }
  sort_by(enclosures, [](const Enclosure& a, const Enclosure& b) {
    return a.inner != b.inner ? a.inner < b.inner : a.outer < b.outer;
  });
  return enclosures;
}

}  // namespace kdm
