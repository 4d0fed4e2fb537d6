// SPDX-License-Identifier: MIT
// Looks for the smallest polygon round a corner of each polygon, larger polygons first.
#include "prepare/nested_polygons.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "geometry/exact_sign.h"
#include "mesh/box_tree.h"
#include "mesh/marks.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

// Limits the work, counted in corners looked at.
constexpr std::uint64_t kMostSteps = std::uint64_t{1} << 26;

class PolygonNesting {
 public:
  PolygonNesting(const std::vector<HolePolygon>& polygons, const std::vector<Vec3>& points,
                 double distance)
      : polygons_(polygons), points_(points), distance_(distance) {}

  std::vector<std::vector<Index>> run() {
    std::vector<Box> boxes;
    for (const HolePolygon& polygon : polygons_) boxes.push_back(polygon.bounds);
    const BoxTree tree(boxes);
    const auto larger = [&](Index a, Index b) { return polygons_[a].area > polygons_[b].area; };
    const std::vector<Index> order = in_order(polygons_.size(), Order(larger));
    std::vector<std::vector<Index>> holes_in(polygons_.size());
    Marks is_hole(polygons_.size());
    for (const Index inner : order) {
      const Index outer = smallest_round(inner, tree);
      if (outer == kNone || is_hole.test(outer)) continue;
      if (polygons_[outer].normal.dot(polygons_[inner].normal) >= 0) continue;
      is_hole.set(inner);
      holes_in[outer].push_back(inner);
    }
    std::vector<std::vector<Index>> groups;
    for (Index outer = 0; outer < polygons_.size(); ++outer) {
      if (is_hole.test(outer)) continue;
      sort_numbers(holes_in[outer]);
      groups.push_back({outer});
      groups.back().insert(groups.back().end(), holes_in[outer].begin(), holes_in[outer].end());
    }
    return groups;
  }

 private:
  // Returns the smallest polygon of the same plane that holds a corner of `inner`, or kNone.
  Index smallest_round(Index inner, const BoxTree& tree) {
    const HolePolygon& polygon = polygons_[inner];
    const Vec3& corner = points_[polygon.corners[0]];
    Index smallest = kNone;
    tree.any_meeting({corner, corner}, [&](Index outer) {
      if (++work_ > kMostSteps) return true;
      const double area = polygons_[outer].area;
      if (outer == inner || !(area > polygon.area)) return false;
      if (smallest != kNone) {
        const double least = polygons_[smallest].area;
        if (area > least || (area == least && outer > smallest)) return false;
      }
      if (in_plane_of(outer, polygon) && holds(outer, corner)) smallest = outer;
      return false;
    });
    return work_ > kMostSteps ? kNone : smallest;
  }

  bool in_plane_of(Index outer, const HolePolygon& inner) {
    const HolePolygon& plane = polygons_[outer];
    const auto off = [&](const Vec3& p) {
      return std::abs(plane.normal.dot(p - plane.centre)) > distance_;
    };
    if (off(inner.centre)) return false;
    work_ += inner.corners.size();
    return std::none_of(inner.corners.begin(), inner.corners.end(),
                        [&](PointId p) { return off(points_[p]); });
  }

  // Tells whether the polygon runs round a point, seen along the axis nearest to its normal:
  // whether a ray along the next axis meets its edges an odd number of times.
  bool holds(Index outer, const Vec3& point) {
    const HolePolygon& polygon = polygons_[outer];
    work_ += polygon.corners.size();
    int axis = 0;
    polygon.normal.cwiseAbs().maxCoeff(&axis);
    const int v = (axis + 2) % 3;
    bool inside = false;
    PointId last = polygon.corners.back();
    for (const PointId next : polygon.corners) {
      const Vec3& a = points_[last];
      const Vec3& b = points_[next];
      last = next;
      const bool upwards = b[v] > a[v];
      if ((a[v] > point[v]) == (b[v] > point[v])) continue;
      if (area_sign(a, b, point, axis) == (upwards ? 1 : -1)) inside = !inside;
    }
    return inside;
  }

  const std::vector<HolePolygon>& polygons_;
  const std::vector<Vec3>& points_;
  double distance_;
  std::uint64_t work_ = 0;
};

}  // namespace

std::vector<std::vector<Index>> group_nested(const std::vector<HolePolygon>& polygons,
                                             const std::vector<Vec3>& points, double distance) {
  return PolygonNesting(polygons, points, distance).run();
}

}  // namespace kdm
