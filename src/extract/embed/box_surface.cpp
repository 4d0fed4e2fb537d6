// SPDX-License-Identifier: MIT
// Box sides triangulated one by one, then parted along the curves.
#include "extract/embed/box_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

#include "geometry/exact_sign.h"

namespace kdm {
namespace {

using Edge = std::pair<Index, Index>;

constexpr double kNear = 0.25;  // lattice units

Edge undirected(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

// A bit for each side of the box that the point lies on: 1 << axis at the low end, 8 << axis at the
// high end.
unsigned sides_of(const Vec3& lo, const Vec3& hi, const Vec3& p) {
  unsigned sides = 0;
  for (int i = 0; i < 3; ++i) {
    if (p[i] == lo[i]) sides |= 1u << i;
    if (p[i] == hi[i]) sides |= 8u << i;
  }
  return sides;
}

// Of the points on one side of the box: the edges that must be, then the shortest that cross none
// of those before, until there is no more.
class SideTriangulation {
 public:
  SideTriangulation(const std::vector<Vec3>& points, int axis, std::vector<Index> numbers)
      : points_(points), axis_(axis), numbers_(std::move(numbers)) {}

  // False if it crosses others or goes through points.
  bool add(Index a, Index b) {
    if (!fits(a, b)) return false;
    edges_.push_back(undirected(a, b));
    return true;
  }

  void complete() {
    struct Candidate {
      double length;
      Edge edge;
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
    std::sort(candidates.begin(), candidates.end());
    for (const Candidate& c : candidates) {
      if (!passes_by(c.edge.first, c.edge.second)) add(c.edge.first, c.edge.second);
    }
    for (const Candidate& c : candidates) add(c.edge.first, c.edge.second);
    std::sort(edges_.begin(), edges_.end());
  }

  // Counter-clockwise seen against the axis.
  void append_triangles(bool reversed, std::vector<Triangle>& triangles) const {
    for (const auto& [a, b] : edges_) {
      for (const Index c : numbers_) {
        if (c <= b || !has(a, c) || !has(b, c)) continue;
        const int sign = area(a, b, c);
        if (sign == 0 || !empty(a, b, c, sign)) continue;
        const bool turn = (sign < 0) != reversed;
        triangles.push_back(turn ? Triangle{a, c, b} : Triangle{a, b, c});
      }
    }
  }

 private:
  int area(Index a, Index b, Index c) const {
    return area_sign(points_[a], points_[b], points_[c], axis_);
  }

  bool has(Index a, Index b) const {
    return std::binary_search(edges_.begin(), edges_.end(), undirected(a, b));
  }

  bool fits(Index a, Index b) const {
    if (std::find(edges_.begin(), edges_.end(), undirected(a, b)) != edges_.end()) return false;
    for (const Index c : numbers_) {
      if (c != a && c != b && area(a, b, c) == 0 && between(a, b, c)) return false;
    }
    return std::none_of(edges_.begin(), edges_.end(), [&](const Edge& edge) {
      const auto [c, d] = edge;
      if (c == a || c == b || d == a || d == b) return false;  // or one went through a point
      return area(a, b, c) * area(a, b, d) < 0 && area(c, d, a) * area(c, d, b) < 0;
    });
  }

  // Does the edge come so near to a point that their triangle would have no width in 32 bits?
  bool passes_by(Index a, Index b) const {
    const Vec3 edge = points_[b] - points_[a];
    return std::any_of(numbers_.begin(), numbers_.end(), [&](Index c) {
      if (c == a || c == b) return false;
      const double along = edge.dot(points_[c] - points_[a]);
      if (!(along > 0 && along < edge.squaredNorm())) return false;
      return (points_[c] - points_[a]).cross(edge).norm() < kNear * edge.norm();
    });
  }

  bool between(Index a, Index b, Index c) const {
    const Vec3& p = points_[c];
    return (p.array() >= points_[a].cwiseMin(points_[b]).array()).all() &&
           (p.array() <= points_[a].cwiseMax(points_[b]).array()).all();
  }

  bool empty(Index a, Index b, Index c, int sign) const {
    return std::none_of(numbers_.begin(), numbers_.end(), [&](Index p) {
      return p != a && p != b && p != c && sign * area(a, b, p) >= 0 && sign * area(b, c, p) >= 0 &&
             sign * area(c, a, p) >= 0;
    });
  }

  const std::vector<Vec3>& points_;
  int axis_;
  std::vector<Index> numbers_;
  std::vector<Edge> edges_;
};

class Caps {
 public:
  Caps(BoxSurface& surface, const std::vector<Curve>& curves)
      : surface_(surface), curves_(curves) {}

  bool find() {
    for (Index t = 0; t < surface_.triangles.size(); ++t) {
      for (int i = 0; i < 3; ++i) {
        const Triangle& corners = surface_.triangles[t];
        sides_.push_back({{corners[i], corners[(i + 1) % 3]}, t});
      }
    }
    std::sort(sides_.begin(), sides_.end());
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      const auto [a, b] = sides_[i].first;
      if (i > 0 && sides_[i].first == sides_[i - 1].first) return false;
      if (left_of(b, a) == kNone) return false;
    }
    for (Index c = 0; c < curves_.size(); ++c) {
      for (std::size_t i = 0; i < curves_[c].size(); ++i) {
        const Edge edge = undirected(curves_[c][i], curves_[c][(i + 1) % curves_[c].size()]);
        if (left_of(edge.first, edge.second) == kNone) return false;
        barriers_.push_back({edge, c});
      }
    }
    std::sort(barriers_.begin(), barriers_.end());
    find_regions();
    if (areas_.size() != curves_.size() + 1) return false;
    surface_.caps.resize(curves_.size());
    const auto largest = std::max_element(areas_.begin(), areas_.end());
    descend(static_cast<Index>(largest - areas_.begin()), kNone);
    for (const BoxSurface::Cap& cap : surface_.caps) {
      surface_.levels = std::max(surface_.levels, cap.level);
    }
    return true;
  }

 private:
  // The triangle left of the directed edge, or kNone.
  Index left_of(Index a, Index b) const {
    const auto side =
        std::lower_bound(sides_.begin(), sides_.end(), std::pair<Edge, Index>{{a, b}, Index{0}});
    return side != sides_.end() && side->first == Edge{a, b} ? side->second : kNone;
  }

  bool barred(Index a, Index b) const {
    const Edge edge = undirected(a, b);
    const auto found = std::lower_bound(barriers_.begin(), barriers_.end(),
                                        std::pair<Edge, Index>{edge, Index{0}});
    return found != barriers_.end() && found->first == edge;
  }

  void find_regions() {
    region_.assign(surface_.triangles.size(), kNone);
    for (Index start = 0; start < region_.size(); ++start) {
      if (region_[start] != kNone) continue;
      const auto region = static_cast<Index>(areas_.size());
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
          const Index beyond = left_of(b, a);
          if (barred(a, b) || region_[beyond] != kNone) continue;
          region_[beyond] = region;
          stack.push_back(beyond);
        }
      }
      areas_.push_back(area);
    }
  }

  // The curves that bound the region, but for the one it was reached by, have their caps beyond.
  // Returns the largest of their levels and appends all of the caps' triangles.
  int descend(Index region, Index from, std::vector<Index>* triangles = nullptr) {
    int level = 0;
    for (Index c = 0; c < curves_.size(); ++c) {
      if (c == from) continue;
      const Index left = region_[left_of(curves_[c][0], curves_[c][1])];
      const Index right = region_[left_of(curves_[c][1], curves_[c][0])];
      if (left != region && right != region) continue;
      BoxSurface::Cap& cap = surface_.caps[c];
      cap.left = right == region;
      const Index beyond = cap.left ? left : right;
      for (Index t = 0; t < region_.size(); ++t) {
        if (region_[t] == beyond) cap.triangles.push_back(t);
      }
      cap.level = 1 + descend(beyond, c, &cap.triangles);
      level = std::max(level, cap.level);
      if (triangles == nullptr) continue;
      triangles->insert(triangles->end(), cap.triangles.begin(), cap.triangles.end());
    }
    return level;
  }

  BoxSurface& surface_;
  const std::vector<Curve>& curves_;
  std::vector<std::pair<Edge, Index>> sides_;     // directed edges and their triangles
  std::vector<std::pair<Edge, Index>> barriers_;  // edges of curves
  std::vector<Index> region_;                     // per triangle
  std::vector<double> areas_;                     // per region
};

}  // namespace

std::optional<BoxSurface> triangulate_box(const Vec3& lo, const Vec3& hi, std::vector<Vec3> points,
                                          const std::vector<Curve>& curves) {
  BoxSurface surface;
  surface.points = std::move(points);
  for (int bits = 0; bits < 8; ++bits) {
    Vec3 corner = lo;
    for (int i = 0; i < 3; ++i) {
      if ((bits >> i & 1) != 0) corner[i] = hi[i];
    }
    surface.points.push_back(corner);
  }
  std::vector<unsigned> sides;
  for (const Vec3& p : surface.points) sides.push_back(sides_of(lo, hi, p));
  const auto on_one_side = [&](Index a, Index b) {
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
        if (!on_one_side(a, b)) return std::nullopt;
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
