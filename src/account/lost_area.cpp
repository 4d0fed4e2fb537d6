// SPDX-License-Identifier: MIT
// Finds what of an input its result does not come near.
#include "account/lost_area.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "mesh/disjoint_sets.h"
#include "mesh/marks.h"
#include "mesh/sort.h"
#include "mesh/spread.h"
#include "prepare/weld.h"

namespace kdm {
namespace {

constexpr double kPointsOfInput = 16384;
// Sides of small faces are twice as long as what counts as far, at most: this is the square.
constexpr double kSmall = 4;

// A triangle that is lost in whole or part.
struct LostTriangle {
  Index triangle;
  double area;
};

class Search {
 public:
  explicit Search(BothSurfaces& both) : both_(both), far_(both.reach * both.reach) {
    const auto mark = [&](const auto& has_hit) {
      Marks marks(both.input.positions.size());
      for (Index t = 0; t < both.input.size(); ++t) {
        if (!has_hit(t)) continue;
        for (const Index v : both.input.triangles[t]) marks.set(v);
      }
      near_hit_ = std::move(marks);
    };
    mark([&](Index t) { return both.in_result(t) != kNone; });
    mark([&](Index t) { return has_hit_nearby(t) && is_small(t); });
  }

  void run() {
    TriangleSet& input = both_.input;
    Spread spread(both_.input_area / kPointsOfInput);
    for (Index t = 0; t < input.size(); ++t) {
      const Vec3& a = input.corner(t, 0);
      const Vec3& b = input.corner(t, 1);
      const Vec3& c = input.corner(t, 2);
      const bool known = has_hit_nearby(t) && is_small(t);
      const double area = input.area_of(t);
      looked_at_ = missing_ = inner_ = 0;
      spread.for_each_point(a, b, c, area, [&](const Vec3& p) {
        if (!known) look_at(t, p);
      });
      if (!known && looked_at_ == 0) look_at(t, (a + b + c) / 3);
      if (missing_ > 0) lost.push_back({t, area * missing_ / looked_at_});
      if (inner_ > 0) inner_area += area * inner_ / looked_at_;
    }
  }

  std::vector<LostTriangle> lost;
  double inner_area = 0;

 private:
  bool is_small(Index t) const {
    const Vec3& a = both_.input.corner(t, 0);
    const Vec3& b = both_.input.corner(t, 1);
    const Vec3& c = both_.input.corner(t, 2);
    return std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}) <=
           kSmall * far_;
  }

  bool has_hit_nearby(Index t) const {
    const Triangle& corners = both_.input.triangles[t];
    return near_hit_.test(corners[0]) || near_hit_.test(corners[1]) || near_hit_.test(corners[2]);
  }

  void look_at(Index t, const Vec3& point) {
    ++looked_at_;
    if (both_.result.squared_distance(point, far_, both_.in_result(t)) <= far_) return;
    if (both_.is_inner(t, point)) {
      ++inner_;
    } else if (!both_.is_cut_off(t, point)) {
      ++missing_;
    }
  }

  BothSurfaces& both_;
  double far_;
  Marks near_hit_;  // vertices of faces that have hits, or of their small neighbours
  int looked_at_ = 0;
  int missing_ = 0;
  int inner_ = 0;
};

// Per triangle its corners' points: equal positions are one.
std::vector<Triangle> joined(const TriangleSet& input, const std::vector<LostTriangle>& lost) {
  std::vector<Vec3> corners;
  for (const LostTriangle& l : lost) {
    for (int i = 0; i < 3; ++i) corners.push_back(input.corner(l.triangle, i));
  }
  const Weld weld = weld_positions(corners);
  std::vector<Triangle> triangles;
  for (Index i = 0; i < corners.size(); i += 3) {
    triangles.push_back({weld.point_of[i], weld.point_of[i + 1], weld.point_of[i + 2]});
  }
  return triangles;
}

// Sets the area of further triangles over the same corners to 0.
void leave_copies_out(std::vector<Triangle> corners, std::vector<LostTriangle>& lost) {
  for (Triangle& t : corners) {
    if (t[1] < t[0]) std::swap(t[0], t[1]);
    if (t[2] < t[1]) std::swap(t[1], t[2]);
    if (t[1] < t[0]) std::swap(t[0], t[1]);
  }
  const auto before = [&](Index i, Index j) { return corners[i] < corners[j]; };
  const std::vector<Index> order = in_order(lost.size(), Order(before));
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (corners[order[i]] == corners[order[i - 1]]) lost[order[i]].area = 0;
  }
}

}  // namespace

LostArea find_lost_area(BothSurfaces& both) {
  LostArea found;
  if (both.input.triangles.empty()) return found;
  Search search(both);
  search.run();
  std::vector<LostTriangle>& lost = search.lost;
  const double unit_area = both.unit * both.unit;
  found.inner_area = search.inner_area * unit_area;
  const std::vector<Triangle> corners = joined(both.input, lost);
  leave_copies_out(corners, lost);
  DisjointSets sets(3 * lost.size());
  for (const Triangle& t : corners) {
    sets.join(t[0], t[1]);
    sets.join(t[1], t[2]);
  }
  std::vector<double> area_of_part(3 * lost.size(), 0);
  for (std::size_t i = 0; i < lost.size(); ++i) {
    double& area = area_of_part[sets.find(corners[i][0])];
    if (area == 0) ++found.parts;
    area += lost[i].area * unit_area;
    found.area += lost[i].area * unit_area;
    found.largest = std::max(found.largest, area);
    found.faces.push_back(both.input.faces[lost[i].triangle]);
  }
  found.share = found.area / (both.input_area * unit_area);
  return found;
}

}  // namespace kdm
