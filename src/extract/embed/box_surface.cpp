// SPDX-License-Identifier: MIT
// Triangulates the sides of a box one by one, and finds the regions between curves and the curves'
// caps.
#include "extract/embed/box_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "geometry/exact_sign.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

using BoxEdge = std::pair<Index, Index>;  // by the numbers of its ends

// Edges that pass a point at less than this distance, in lattice units, are taken last: the
// triangle between them might have no width when its corners are rounded to 32 bits.
constexpr double kLeastDistance = 0.25;

BoxEdge undirected(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

// Returns one bit for each side of the box that the point lies on: 1 << axis for the side at the
// low end, 8 << axis for that at the high end.
unsigned sides_of(const Vec3& lo, const Vec3& hi, const Vec3& p) {
  unsigned sides = 0;
  for (int i = 0; i < 3; ++i) {
    if (p[i] == lo[i]) sides |= 1u << i;
    if (p[i] == hi[i]) sides |= 8u << i;
  }
  return sides;
}

// Triangulates one side of the box, with all points on it: first come the edges that must be, then
// always the shortest edge that crosses none of those before, until there are no more.
class SideTriangulation {
 public:
  SideTriangulation(const std::vector<Vec3>& points, int axis, std::vector<Index> numbers)
      : points_(points), axis_(axis), numbers_(std::move(numbers)) {}

  // Adds an edge, unless it is there, crosses others or goes through points; then returns false.
  bool add(Index a, Index b) {
    if (!can_be_added(a, b)) return false;
    edges_.push_back(undirected(a, b));
    return true;
  }

  // Adds edges until all faces between them are triangles.
  void complete() {
    struct Candidate {
      double length;
      BoxEdge edge;
      bool operator<(const Candidate& other) const {
        return length != other.length ? length < other.length : edge < other.edge;
      }
    };
    std::vector<Candidate> candidates;
    for (const Index a : numbers_) {
      for (const Index b : numbers_) {
        if (a < b) candidates.push_back({(points_[b] - points_[a]).squaredNorm(), {a, b}});
      }
    }
    sort_up(candidates);
    for (const Candidate& c : candidates) {
      if (!passes_near_point(c.edge.first, c.edge.second)) add(c.edge.first, c.edge.second);
    }
    for (const Candidate& c : candidates) add(c.edge.first, c.edge.second);
    sort_up(edges_);
  }

  // Appends the faces between the edges: counter-clockwise seen from above, against the direction
  // of the axis, or `reversed`.
  void append_triangles(bool reversed, std::vector<Triangle>& triangles) const {
    for (const auto& [a, b] : edges_) {
      for (const Index c : numbers_) {
        if (c <= b || !has_edge(a, c) || !has_edge(b, c)) continue;
        const int sign = orientation(a, b, c);
        if (sign == 0 || holds_points(a, b, c, sign)) continue;
        const bool exchange = (sign < 0) != reversed;
        triangles.push_back(exchange ? Triangle{a, c, b} : Triangle{a, b, c});
      }
    }
  }

 private:
  // Returns the sign of the triangle's area: positive if it is counter-clockwise seen from above.
  int orientation(Index a, Index b, Index c) const {
    return area_sign(points_[a], points_[b], points_[c], axis_);
  }

  bool has_edge(Index a, Index b) const {
    return std::binary_search(edges_.begin(), edges_.end(), undirected(a, b));
  }

  bool can_be_added(Index a, Index b) const {
    if (std::find(edges_.begin(), edges_.end(), undirected(a, b)) != edges_.end()) return false;
    for (const Index c : numbers_) {
      if (c != a && c != b && orientation(a, b, c) == 0 && between(a, b, c)) return false;
    }
    return std::none_of(edges_.begin(), edges_.end(), [&](const BoxEdge& edge) {
      const auto [c, d] = edge;
      // Edges that share an end meet nowhere else, or one would go through an end of the other.
      if (c == a || c == b || d == a || d == b) return false;
      return orientation(a, b, c) * orientation(a, b, d) < 0 &&
             orientation(c, d, a) * orientation(c, d, b) < 0;
    });
  }

  // Tells whether the edge passes a point other than its ends at less than `kLeastDistance`.
  bool passes_near_point(Index a, Index b) const {
    const Vec3 edge = points_[b] - points_[a];
    return std::any_of(numbers_.begin(), numbers_.end(), [&](Index c) {
      if (c == a || c == b) return false;
      const double along = edge.dot(points_[c] - points_[a]);
      if (!(along > 0 && along < edge.squaredNorm())) return false;
      return (points_[c] - points_[a]).cross(edge).norm() < kLeastDistance * edge.norm();
    });
  }

  // Tells whether point c, on the line through a and b, lies between them.
  bool between(Index a, Index b, Index c) const {
    const Vec3& p = points_[c];
    return (p.array() >= points_[a].cwiseMin(points_[b]).array()).all() &&
           (p.array() <= points_[a].cwiseMax(points_[b]).array()).all();
  }

  // Tells whether a point other than its corners lies in the triangle, of this orientation.
  bool holds_points(Index a, Index b, Index c, int sign) const {
    return std::any_of(numbers_.begin(), numbers_.end(), [&](Index p) {
      return p != a && p != b && p != c && sign * orientation(a, b, p) >= 0 &&
             sign * orientation(b, c, p) >= 0 && sign * orientation(c, a, p) >= 0;
    });
  }

  const std::vector<Vec3>& points_;
  int axis_;
  std::vector<Index> numbers_;  // of the points on this side of the box
  std::vector<BoxEdge> edges_;  // undirected; sorted once complete
};

// Finds the regions into which curves cut a triangulated surface, and from these the curves' caps.
class Caps {
 public:
  Caps(BoxSurface& surface, const std::vector<Curve>& curves)
      : surface_(surface), curves_(curves) {}

  // Fills in the caps. Returns false if the triangles make no closed surface, if a curve does not
  // run along their edges, or if the curves are not simple and disjoint.
  bool find() {
    if (!read_triangles() || !read_curves()) return false;
    find_regions();
    // Each of several simple, disjoint curves on a sphere adds one region.
    if (region_areas_.size() != curves_.size() + 1) return false;
    surface_.caps.resize(curves_.size());
    const auto largest = std::max_element(region_areas_.begin(), region_areas_.end());
    find_caps_beside(static_cast<Index>(largest - region_areas_.begin()), kNone, nullptr);
    for (const BoxSurface::Cap& cap : surface_.caps) {
      surface_.levels = std::max(surface_.levels, cap.level);
    }
    return true;
  }

 private:
  struct SideOfTriangle {
    BoxEdge edge;  // directed: the triangle lies to the left
    Index triangle;
    bool operator<(const SideOfTriangle& other) const {
      return edge != other.edge ? edge < other.edge : triangle < other.triangle;
    }
  };

  bool read_triangles() {
    for (Index t = 0; t < surface_.triangles.size(); ++t) {
      const Triangle& corners = surface_.triangles[t];
      for (int i = 0; i < 3; ++i) sides_.push_back({{corners[i], corners[(i + 1) % 3]}, t});
    }
    sort_up(sides_);
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      const auto [a, b] = sides_[i].edge;
      if (i > 0 && sides_[i].edge == sides_[i - 1].edge) return false;
      if (triangle_left_of(b, a) == kNone) return false;
    }
    return true;
  }

  bool read_curves() {
    for (const Curve& curve : curves_) {
      for (std::size_t i = 0; i < curve.size(); ++i) {
        const BoxEdge edge = undirected(curve[i], curve[(i + 1) % curve.size()]);
        if (triangle_left_of(edge.first, edge.second) == kNone) return false;
        curve_edges_.push_back(edge);
      }
    }
    sort_up(curve_edges_);
    return true;
  }

  // Returns the triangle to the left of the directed edge, seen from outside, or kNone.
  Index triangle_left_of(Index a, Index b) const {
    const auto side = std::lower_bound(sides_.begin(), sides_.end(), SideOfTriangle{{a, b}, 0});
    return side != sides_.end() && side->edge == BoxEdge{a, b} ? side->triangle : kNone;
  }

  bool is_on_curve(Index a, Index b) const {
    return std::binary_search(curve_edges_.begin(), curve_edges_.end(), undirected(a, b));
  }

  // Numbers the regions, and finds their areas.
  void find_regions() {
    region_.assign(surface_.triangles.size(), kNone);
    for (Index start = 0; start < region_.size(); ++start) {
      if (region_[start] == kNone) region_areas_.push_back(flood_region(start));
    }
  }

  // Gives the triangle and all that are joined to it without crossing a curve the next region's
  // number. Returns twice their area.
  double flood_region(Index start) {
    const auto region = static_cast<Index>(region_areas_.size());
    double area = 0;
    std::vector<Index> stack = {start};
    region_[start] = region;
    while (!stack.empty()) {
      const Triangle t = surface_.triangles[stack.back()];
      stack.pop_back();
      const Vec3& p = surface_.points[t[0]];
      area += (surface_.points[t[1]] - p).cross(surface_.points[t[2]] - p).norm();
      for (int i = 0; i < 3; ++i) {
        const Index a = t[i];
        const Index b = t[(i + 1) % 3];
        const Index beyond = triangle_left_of(b, a);
        if (is_on_curve(a, b) || region_[beyond] != kNone) continue;
        region_[beyond] = region;
        stack.push_back(beyond);
      }
    }
    return area;
  }

  // Finds the caps of all curves that bound the region, but for the curve `from` through which it
  // was reached: each begins with the region beyond its curve and holds the caps that this one
  // has beside it in turn. Appends the triangles of these caps to `triangles` unless it is null,
  // and returns the greatest of their levels, 0 if there are none.
  int find_caps_beside(Index region, Index from, std::vector<Index>* triangles) {
    int greatest_level = 0;
    for (Index c = 0; c < curves_.size(); ++c) {
      if (c == from) continue;
      const Index left = region_[triangle_left_of(curves_[c][0], curves_[c][1])];
      const Index right = region_[triangle_left_of(curves_[c][1], curves_[c][0])];
      if (left != region && right != region) continue;
      BoxSurface::Cap& cap = surface_.caps[c];
      cap.left = right == region;
      const Index beyond = cap.left ? left : right;
      for (Index t = 0; t < region_.size(); ++t) {
        if (region_[t] == beyond) cap.triangles.push_back(t);
      }
      cap.level = 1 + find_caps_beside(beyond, c, &cap.triangles);
      greatest_level = std::max(greatest_level, cap.level);
      if (triangles == nullptr) continue;
      triangles->insert(triangles->end(), cap.triangles.begin(), cap.triangles.end());
    }
    return greatest_level;
  }

  BoxSurface& surface_;
  const std::vector<Curve>& curves_;
  std::vector<SideOfTriangle> sides_;  // of all triangles, sorted
  std::vector<BoxEdge> curve_edges_;   // of all curves; undirected, sorted
  std::vector<Index> region_;          // per triangle
  std::vector<double> region_areas_;   // per region
};

// Returns the points, followed by the corners of the box.
std::vector<Vec3> with_corners(std::vector<Vec3> points, const Vec3& lo, const Vec3& hi) {
  for (int bits = 0; bits < 8; ++bits) {
    Vec3 corner = lo;
    for (int i = 0; i < 3; ++i) {
      if ((bits >> i & 1) != 0) corner[i] = hi[i];
    }
    points.push_back(corner);
  }
  return points;
}

}  // namespace

std::optional<BoxSurface> triangulate_box(const Vec3& lo, const Vec3& hi, std::vector<Vec3> points,
                                          const std::vector<Curve>& curves) {
  BoxSurface surface;
  surface.points = with_corners(std::move(points), lo, hi);
  std::vector<unsigned> sides;  // per point
  for (const Vec3& p : surface.points) sides.push_back(sides_of(lo, hi, p));
  const auto on_exactly_one_side = [&](Index a, Index b) {
    const unsigned common = sides[a] & sides[b];
    return common != 0 && (common & (common - 1)) == 0;
  };
  for (int side = 0; side < 6; ++side) {
    const auto on_side = [&](Index p) { return (sides[p] >> side & 1) != 0; };
    std::vector<Index> numbers;
    for (Index p = 0; p < sides.size(); ++p) {
      if (on_side(p)) numbers.push_back(p);
    }
    SideTriangulation triangulation(surface.points, side % 3, std::move(numbers));
    for (const Curve& curve : curves) {
      for (std::size_t i = 0; i < curve.size(); ++i) {
        const Index a = curve[i];
        const Index b = curve[(i + 1) % curve.size()];
        if (!on_exactly_one_side(a, b)) return std::nullopt;
        if (on_side(a) && on_side(b) && !triangulation.add(a, b)) return std::nullopt;
      }
    }
    triangulation.complete();
    triangulation.append_triangles(side < 3, surface.triangles);
  }
  if (!Caps(surface, curves).find()) return std::nullopt;
  return surface;
}

}  // namespace kdm
