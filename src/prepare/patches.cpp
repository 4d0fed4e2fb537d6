// SPDX-License-Identifier: MIT
// Tries a flat patch for each hole and takes the patch of least area where there is none.
#include "prepare/patches.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geometry/triangle.h"
#include "mesh/marks.h"
#include "mesh/scale.h"
#include "mesh/sides.h"
#include "mesh/sort.h"
#include "prepare/flat_patch.h"
#include "prepare/least_area_patch.h"
#include "prepare/nested_polygons.h"
#include "threads/share_work.h"

namespace kdm {
namespace {

// Returns the edges between two points at holes, each as lower point * 2^32 + upper point.
std::vector<std::uint64_t> edges_between(const Marks& at_hole,
                                         std::span<const Triangle> triangles) {
  std::vector<std::uint64_t> edges;
  for (const Triangle& t : triangles) {
    for (int i = 0; i < 3; ++i) {
      const PointId a = t[i];
      const PointId b = t[next_corner(i)];
      if (!at_hole.test(a) || !at_hole.test(b)) continue;
      edges.push_back(std::uint64_t{std::min(a, b)} << 32 | std::max(a, b));
    }
  }
  sort_numbers(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

class Patcher {
 public:
  Patcher(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
          const std::vector<Hole>& holes, double flatness)
      : scaled_(scale_to_one(points, triangles)),
        flatness_(std::ldexp(flatness, -scaled_.exponent)),
        flat_patch_(scaled_.positions) {
    Marks at_hole(points.size());
    for (const Hole& hole : holes) {
      polygons_.push_back(measure_hole(hole.sides, triangles, scaled_.positions));
      for (const PointId p : polygons_.back().corners) at_hole.set(p);
    }
    edges_ = edges_between(at_hole, triangles);
  }

  std::vector<Patch> run() {
    find_flat();
    for (std::vector<Index>& group : group_nested(flat_, scaled_.positions, flatness_)) {
      if (add_flat(group) || group.size() == 1) continue;
      for (const Index alone : group) add_flat({alone});
    }
    add_least_area();
    const auto earlier = [&](Index a, Index b) {
      return patches_[a].holes[0] < patches_[b].holes[0];
    };
    std::vector<Patch> sorted;
    for (const Index patch : in_order(patches_.size(), Order(earlier))) {
      sorted.push_back(std::move(patches_[patch]));
    }
    return sorted;
  }

 private:
  void find_flat() {
    closed_.assign(polygons_.size());
    for (Index hole = 0; hole < polygons_.size(); ++hole) {
      const HolePolygon& polygon = polygons_[hole];
      const double width = polygon.area / (polygon.bounds.max - polygon.bounds.min).norm();
      if (!(width > flatness_) || polygon.deviation > flatness_) continue;
      flat_.push_back(polygon);
      hole_of_.push_back(hole);
    }
  }

  // Closes some flat polygons by one patch. Returns false if that is not possible.
  bool add_flat(const std::vector<Index>& group) {
    Patch patch;
    if (!flat_patch_.make(flat_, group, patch.triangles)) return false;
    const HolePolygon& outer = flat_[group[0]];
    patch.normal = outer.normal;
    for (int i = 0; i < 3; ++i) patch.point[i] = std::ldexp(outer.centre[i], scaled_.exponent);
    for (const Index polygon : group) {
      patch.holes.push_back(hole_of_[polygon]);
      closed_.set(hole_of_[polygon]);
    }
    add(std::move(patch), outer.bounds);
    return true;
  }

  // Closes the holes that are left.
  void add_least_area() {
    std::vector<Patch> patches;
    std::vector<std::size_t> corners;
    for (Index hole = 0; hole < polygons_.size(); ++hole) {
      if (closed_.test(hole)) continue;
      patches.emplace_back().holes.push_back(hole);
      corners.push_back(polygons_[hole].corners.size());
    }
    const int threads = LeastAreaPatch::is_little_work(corners) ? workers() : 1;
    std::vector<LeastAreaPatch> makers(static_cast<std::size_t>(threads),
                                       LeastAreaPatch(scaled_.positions, edges_));
    share_work(patches.size(), threads, [&](std::size_t i, int worker) {
      const HolePolygon& polygon = polygons_[patches[i].holes[0]];
      makers[static_cast<std::size_t>(worker)].make(polygon.corners, polygon.beyond,
                                                    patches[i].triangles);
    });
    for (Patch& patch : patches) {
      const Box& bounds = polygons_[patch.holes[0]].bounds;
      add(std::move(patch), bounds);
    }
  }

  void add(Patch&& patch, const Box& bounds) {
    const std::vector<Vec3>& p = scaled_.positions;
    double area = 0;
    for (const Triangle& t : patch.triangles) {
      area += doubled_area_vector(p[t[0]], p[t[1]], p[t[2]]).norm() / 2;
    }
    patch.area = std::ldexp(area, 2 * scaled_.exponent);
    patch.narrow = !(area > flatness_ * (bounds.max - bounds.min).norm());
    patches_.push_back(std::move(patch));
  }

  ScaledPositions scaled_;
  double flatness_;
  std::vector<std::uint64_t> edges_;
  std::vector<HolePolygon> polygons_;  // of the holes
  std::vector<HolePolygon> flat_;      // those of them that are flat
  std::vector<Index> hole_of_;         // per flat polygon
  Marks closed_;                       // per hole
  FlatPatch flat_patch_;
  std::vector<Patch> patches_;
};

}  // namespace

std::vector<Patch> make_patches(std::span<const Triangle> triangles,
                                const std::vector<Vec3>& points, const std::vector<Hole>& holes,
                                double flatness) {
  return Patcher(triangles, points, holes, flatness).run();
}

}  // namespace kdm
