// SPDX-License-Identifier: MIT
// Winding numbers by rays: those triangles count that a ray down the x axis meets. The point is
// read as shifted by (0, e, e^2), e infinitesimal, so that no ray meets an edge.
#include "analyze/nesting.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "geometry/exact_sign.h"
#include "mesh/box_tree.h"

namespace kdm {
namespace {

using Corners = std::array<Vec3, 3>;

// The limit of work, in pairs of boxes that meet: about a second. A point held against a triangle
// takes as long as several of them. Six thousand parts that all overlap reach it, or two thousand
// round each other, but not a block with a hundred thousand bubbles.
constexpr std::uint64_t kMostTests = std::uint64_t{1} << 25;
constexpr std::uint64_t kTestsAPoint = 4;

bool holds(const Box& a, const Box& b) {
  return (a.min.array() <= b.min.array()).all() && (a.max.array() >= b.max.array()).all();
}

// The vertices furthest out along the eight diagonals, each once: of a box all corners, so that one
// is left if others touch the outer part. None of parts that are open.
std::vector<std::vector<Index>> take_samples(const Polygons& faces, std::span<const Vec3> positions,
                                             std::span<const Index> part_of,
                                             std::span<const Shell> shells) {
  struct Furthest {
    std::array<Index, 8> vertices = {kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone};
    std::array<double, 8> distances = {};
  };
  std::vector<Furthest> furthest(shells.size());
  for (Index face = 0; face < faces.size(); ++face) {
    if (part_of[face] == kNone || !shells[part_of[face]].closed) continue;
    Furthest& found = furthest[part_of[face]];
    for (Index k = 0; k < faces.corners(face); ++k) {
      const Index v = faces[face][k];
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
    std::sort(found.begin(), found.end());
    samples[part].assign(found.begin(), std::unique(found.begin(), found.end()));
  }
  return samples;
}

// The faces of each part, those of part i from place starts[i] on.
struct FacesByPart {
  std::vector<Index> starts;
  std::vector<Index> faces;
};

FacesByPart sort_by_part(std::span<const Index> part_of, std::size_t parts) {
  FacesByPart sorted{std::vector<Index>(parts + 1, 0), {}};
  for (const Index part : part_of) {
    if (part != kNone) ++sorted.starts[part + 1];
  }
  std::partial_sum(sorted.starts.begin(), sorted.starts.end(), sorted.starts.begin());
  sorted.faces.resize(sorted.starts.back());
  std::vector<Index> next(sorted.starts.begin(), sorted.starts.end() - 1);
  for (Index face = 0; face < part_of.size(); ++face) {
    if (part_of[face] != kNone) sorted.faces[next[part_of[face]]++] = face;
  }
  return sorted;
}

int sign(double x) { return x > 0 ? 1 : (x < 0 ? -1 : 0); }

// On which side of the edge the shifted point is, seen along x.
int side_of_edge(const Vec3& a, const Vec3& b, const Vec3& p) {
  const int area = area_sign(a, b, p, 0);
  if (area != 0) return area;
  return a.z() != b.z() ? sign(a.z() - b.z()) : sign(b.y() - a.y());
}

// 0: the line along x through the shifted point misses the triangle; else the sign of the
// triangle's normal along x.
int line_crosses(const Corners& t, const Vec3& p) {
  const int first = side_of_edge(t[0], t[1], p);
  if (first == 0 || side_of_edge(t[1], t[2], p) != first) return 0;
  return side_of_edge(t[2], t[0], p) == first ? first : 0;
}

// For a point in the triangle's plane; triangles without area hold none.
bool is_on(const Corners& t, const Vec3& p) {
  int axis = 0;
  while (axis < 3 && area_sign(t[0], t[1], t[2], axis) == 0) ++axis;
  if (axis == 3) return false;
  bool left = false;
  bool right = false;
  for (int i = 0; i < 3; ++i) {
    const int side = area_sign(t[i], t[i == 2 ? 0 : i + 1], p, axis);
    left = left || side > 0;
    right = right || side < 0;
  }
  return !(left && right);
}

// How the surface of one part lies to a point.
struct Verdict {
  int winding = 0;
  bool on = false;
};

// Asks the triangles of one part about points. `triangles` calls its argument with each of them.
// Counts the work in `tests`, and leaves the rest of the triangles out when it is too much.
template <typename Triangles>
std::vector<Verdict> judge(const std::vector<Box>& points, const Triangles& triangles,
                           std::uint64_t& tests) {
  double highest = points[0].max.x();
  for (const Box& point : points) highest = std::max(highest, point.max.x());
  const BoxTree tree(points);
  std::vector<Verdict> verdicts(points.size());
  triangles([&](const Corners& t) {
    if (tests > kMostTests) return;
    Box above = {t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2])};
    above.max.x() = std::max(above.max.x(), highest);
    tree.for_each_meeting(above, [&](Index i) {
      tests += kTestsAPoint;
      const Vec3& p = points[i].min;
      const int side = volume_sign(t[0], t[1], t[2], p);
      if (side == 0) {
        verdicts[i].on = verdicts[i].on || is_on(t, p);
        return;
      }
      // Below the point if its normal points up the axis and the point is where it points to, or
      // neither. Then the surface is left, or entered, on the way up.
      const int up = line_crosses(t, p);
      if (up == side) verdicts[i].winding -= up;
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
  const FacesByPart sorted = sort_by_part(part_of, shells.size());

  std::uint64_t tests = 0;
  for (const Index outer : closed) {
    std::vector<Index> candidates;
    std::vector<Box> points;
    tree.for_each_meeting(shells[outer].bounds, [&](Index i) {
      ++tests;
      if (closed[i] == outer || !holds(shells[outer].bounds, boxes[i])) return;
      candidates.push_back(closed[i]);
      for (const Index v : samples[closed[i]]) points.push_back({positions[v], positions[v]});
    });
    if (tests > kMostTests) return std::nullopt;
    if (candidates.empty()) continue;
    const std::vector<Verdict> verdicts = judge(
        points,
        [&](const auto& ask) {
          for (Index i = sorted.starts[outer]; i < sorted.starts[outer + 1]; ++i) {
            faces.for_each_triangle_of(sorted.faces[i], [&](const Triangle& t) {
              ask({positions[t[0]], positions[t[1]], positions[t[2]]});
            });
          }
        },
        tests);
    if (tests > kMostTests) return std::nullopt;
    auto verdict = verdicts.begin();
    for (const Index inner : candidates) {
      const auto end = verdict + static_cast<std::ptrdiff_t>(samples[inner].size());
      const bool none_outside =
          std::all_of(verdict, end, [](const Verdict& v) { return v.on || v.winding != 0; });
      const bool one_inside = std::any_of(verdict, end, [](const Verdict& v) { return !v.on; });
      if (none_outside && one_inside) enclosures.push_back({inner, outer});
      verdict = end;
    }
  }
  std::sort(enclosures.begin(), enclosures.end(), [](const Enclosure& a, const Enclosure& b) {
    return a.inner != b.inner ? a.inner < b.inner : a.outer < b.outer;
  });
  return enclosures;
}

}  // namespace kdm
