// SPDX-License-Identifier: MIT
// Joins holes to the outline by bridges that are passed twice: from the corner of a hole furthest
// along one axis to a corner of the outline that is visible from there, further along the axis (D.
// Eberly, Triangulation by Ear Clipping, 2002). Whether the result covers what it should is seen
// from its area.
#include "prepare/flat_patch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/triangle.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

// Limits the work for holes, in corners looked at: to about a second.
constexpr std::size_t kMostFlatWork = std::size_t{1} << 27;
// How far the triangles' area may be from that of the polygons, as a part of it.
constexpr double kMostError = 1e-6;

}  // namespace

bool FlatPatch::make(const std::vector<HolePolygon>& polygons, std::span<const Index> group,
                     std::vector<Triangle>& out) {
  const HolePolygon& outer = polygons[group[0]];
  int axis = 0;
  outer.normal.cwiseAbs().maxCoeff(&axis);
  const bool upwards = outer.normal[axis] > 0;
  u_axis_ = (axis + (upwards ? 1 : 2)) % 3;
  v_axis_ = (axis + (upwards ? 2 : 1)) % 3;
  outline_ = outer.corners;
  double wanted = outer.area;
  const auto end = [&](Index hole) {  // furthest along the axis
    double furthest = -std::numeric_limits<double>::infinity();
    for (const PointId p : polygons[hole].corners) furthest = std::max(furthest, place_of(p).u);
    return furthest;
  };
  std::vector<std::pair<double, Index>> holes;
  for (const Index hole : group.subspan(1)) holes.emplace_back(-end(hole), hole);
  sort_up(holes);
  for (const auto& hole : holes) {
    if (!add_hole(polygons[hole.second])) return false;
    wanted -= polygons[hole.second].area;
  }
  const std::size_t before = out.size();
  out.resize(before + outline_.size() - 2);
  triangulator_.cut(points_, outline_.data(), outline_.size(), out.data() + before);
  double area = 0;
  for (std::size_t i = before; i < out.size(); ++i) {
    const Triangle& t = out[i];
    const Vec3 doubled = doubled_area_vector(points_[t[0]], points_[t[1]], points_[t[2]]);
    area += std::abs(outer.normal.dot(doubled)) / 2;
  }
  if (std::abs(area - wanted) <= kMostError * outer.area) return true;
  out.resize(before);
  return false;
}

FlatPatch::Place FlatPatch::place_of(PointId point) const {
  return {points_[point][u_axis_], points_[point][v_axis_]};
}

// Twice the area of three points in the plane.
double FlatPatch::cross(PointId a, PointId b, PointId c) const {
  const Place p = place_of(a);
  const Place q = place_of(b);
  const Place r = place_of(c);
  return (q.u - p.u) * (r.v - p.v) - (q.v - p.v) * (r.u - p.u);
}

// Joins a hole to the outline. Returns false if no corner is visible from it.
bool FlatPatch::add_hole(const HolePolygon& hole) {
  work_ += outline_.size() + hole.corners.size();
  if (work_ > kMostFlatWork) return false;
  const auto lies_before = [&](PointId a, PointId b) {
    const Place p = place_of(a);
    const Place q = place_of(b);
    return p.u != q.u ? p.u < q.u : p.v < q.v;
  };
  const auto from = std::max_element(hole.corners.begin(), hole.corners.end(), lies_before);
  const std::size_t to = find_visible(*from);
  if (to == outline_.size()) return false;
  std::vector<PointId> bridge(from, hole.corners.end());
  bridge.insert(bridge.end(), hole.corners.begin(), from + 1);
  bridge.push_back(outline_[to]);
  outline_.insert(outline_.begin() + static_cast<std::ptrdiff_t>(to) + 1, bridge.begin(),
                  bridge.end());
  return true;
}

// Returns the place in the outline of a corner that can be seen from a point within it; the size of
// the outline if there is none.
std::size_t FlatPatch::find_visible(PointId from) const {
  const std::size_t size = outline_.size();
  const Place at = place_of(from);
  Place met{std::numeric_limits<double>::infinity(), at.v};
  std::size_t visible = size;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t j = i + 1 < size ? i + 1 : 0;
    const Place a = place_of(outline_[i]);
    const Place b = place_of(outline_[j]);
    if (a.v > at.v || b.v < at.v || a.v == b.v) continue;  // what lies within is left of the edge
    const double u = a.u + (at.v - a.v) / (b.v - a.v) * (b.u - a.u);
    if (u < at.u || u >= met.u) continue;
    met.u = u;
    visible = a.u > b.u ? i : j;
  }
  if (visible == size) return size;
  // Corners between the ray and the one found may be in the way: the one nearest to the ray's
  // direction is visible.
  const PointId tip = outline_[visible];
  double least_slope = std::numeric_limits<double>::infinity();
  double least_way = least_slope;
  for (std::size_t i = 0; i < size; ++i) {
    const PointId p = outline_[i];
    if (p == tip || p == from || !is_within(p, from, met, tip)) continue;
    const PointId before = outline_[i > 0 ? i - 1 : size - 1];
    const PointId after = outline_[i + 1 < size ? i + 1 : 0];
    if (cross(before, p, after) >= 0) continue;  // not in the way of anything
    const Place place = place_of(p);
    const double way = place.u - at.u;
    const double slope = way > 0 ? std::abs(place.v - at.v) / way : least_slope;
    if (slope > least_slope || (slope == least_slope && way >= least_way)) continue;
    least_slope = slope;
    least_way = way;
    visible = i;
  }
  return visible;
}

// Tells whether a point lies in the triangle of a, b and c, its border included.
bool FlatPatch::is_within(PointId p, PointId a, const Place& b, PointId c) const {
  const Place at = place_of(p);
  const auto side = [&](const Place& from, const Place& to) {
    return (to.u - from.u) * (at.v - from.v) - (to.v - from.v) * (at.u - from.u);
  };
  const double first = side(place_of(a), b);
  const double second = side(b, place_of(c));
  const double third = side(place_of(c), place_of(a));
  return (first >= 0 && second >= 0 && third >= 0) || (first <= 0 && second <= 0 && third <= 0);
}

}  // namespace kdm
