// SPDX-License-Identifier: MIT
#include "construct/wall_share.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/triangle.h"
#include "mesh/box_tree.h"
#include "mesh/boxes.h"
#include "mesh/marks.h"

namespace kdm {
namespace {

constexpr Index kProbes = 64;
constexpr double kReach = 4;  // tolerances

double fraction(double x) { return x - std::floor(x); }

// Returns a point of the triangle; points of successive numbers are spread evenly.
Vec3 spread_point(Index number, const Vec3& a, const Vec3& b, const Vec3& c) {
  double u = fraction(0.5 + 0.7548776662466927 * number);
  double v = fraction(0.5 + 0.5698402909980532 * number);
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  return a + u * (b - a) + v * (c - a);
}

// A segment that leads inwards from a point of a triangle.
struct Probe {
  Index triangle;
  Vec3 from;
  Vec3 way;
};

std::vector<Probe> make_probes(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                               double reach) {
  std::vector<double> area_up_to;  // with each triangle
  double area = 0;
  for (const auto& [a, b, c] : triangles) {
    area += doubled_area_vector(points[a], points[b], points[c]).norm();
    area_up_to.push_back(area);
  }
  std::vector<Probe> probes;
  Index t = 0;
  for (Index i = 0; i < kProbes; ++i) {
    const double place = (i + 0.5) / kProbes * area;
    while (t + 1 < triangles.size() && area_up_to[t] <= place) ++t;
    const auto [a, b, c] = triangles[t];
    const Vec3 out = unit_normal(points[a], points[b], points[c]);
    probes.push_back({t, spread_point(i, points[a], points[b], points[c]), -reach * out});
  }
  return probes;
}

// Tells whether the probe passes through the triangle (a, b, c).
bool passes(const Probe& probe, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a;
  const Vec3 v = c - a;
  const Vec3 w = probe.from - a;
  const Vec3 normal = u.cross(v);
  const double along = normal.dot(probe.way);
  if (along == 0) return false;
  const Vec3 across = probe.way.cross(w);
  const double place = -normal.dot(w) / along;
  const double s = v.dot(across) / along;
  const double t = -u.dot(across) / along;
  return place > 0 && place <= 1 && s >= 0 && t >= 0 && s + t <= 1;
}

// Tells at once of most triangles that they are near no probe: a raster over all probes, whose
// squares are marked where one may pass.
class ProbeRaster {
 public:
  explicit ProbeRaster(const std::vector<Box>& probes)
      : marked_(std::size_t{kCells} * kCells * kCells) {
    for (const Box& probe : probes) {
      grow(bounds_, probe.min);
      grow(bounds_, probe.max);
    }
    for (const Box& probe : probes) {
      for_each_cell(probe, [&](Index cell) { return marked_.set(cell), false; });
    }
  }

  bool may_meet(const Box& box) const {
    for (int k = 0; k < 3; ++k) {
      if (box.min[k] > bounds_.max[k] || box.max[k] < bounds_.min[k]) return false;
    }
    return for_each_cell(box, [&](Index cell) { return marked_.test(cell); });
  }

 private:
  static constexpr Index kCells = 32;  // along each axis

  Index cell_of(double x, int axis) const {
    const double width = bounds_.max[axis] - bounds_.min[axis];
    const double place = width > 0 ? (x - bounds_.min[axis]) / width * kCells : 0;
    return static_cast<Index>(std::clamp(place, 0.0, kCells - 1.0));
  }

  // Visits the cells that a box meets, until `visit` returns true; returns whether it did.
  template <typename Visit>
  bool for_each_cell(const Box& box, const Visit& visit) const {
    std::array<Index, 3> lo;
    std::array<Index, 3> hi;
    for (int k = 0; k < 3; ++k) {
      lo[k] = cell_of(box.min[k], k);
      hi[k] = cell_of(box.max[k], k);
    }
    for (Index x = lo[0]; x <= hi[0]; ++x) {
      for (Index y = lo[1]; y <= hi[1]; ++y) {
        for (Index z = lo[2]; z <= hi[2]; ++z) {
          if (visit((x * kCells + y) * kCells + z)) return true;
        }
      }
    }
    return false;
  }

  Box bounds_;
  Marks marked_;
};

}  // namespace

double share_of_walls(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                      double tolerance) {
  const std::vector<Probe> probes = make_probes(triangles, points, kReach * tolerance);
  std::vector<Box> boxes(probes.size());
  for (Index i = 0; i < probes.size(); ++i) {
    grow(boxes[i], probes[i].from);
    grow(boxes[i], probes[i].from + probes[i].way);
  }
  const BoxTree tree(boxes);
  const ProbeRaster raster(boxes);
  Marks meets_wall(probes.size());
  for (Index t = 0; t < triangles.size(); ++t) {
    const Vec3& a = points[triangles[t][0]];
    const Vec3& b = points[triangles[t][1]];
    const Vec3& c = points[triangles[t][2]];
    const Box box = box_of(a, b, c);
    if (!raster.may_meet(box)) continue;
    tree.for_each_meeting(box, [&](Index i) {
      if (t != probes[i].triangle && passes(probes[i], a, b, c)) meets_wall.set(i);
    });
  }
  return static_cast<double>(meets_wall.count()) / kProbes;
}

}  // namespace kdm
