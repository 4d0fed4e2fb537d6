// SPDX-License-Identifier: MIT
#include "prepare/diagonals.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "geometry/triangle.h"
#include "mesh/marks.h"
#include "mesh/sides.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

// The cosine of the largest angle between the normals of a quad's triangles.
constexpr double kFlat = 0.5;

// Two triangles, joined along a diagonal.
struct CutQuad {
  std::array<PointId, 4> points;  // ascending
  SideId diagonal;                // the lower of the two sides
};

class Diagonals {
 public:
  Diagonals(InputFaces& faces, double tolerance)
      : faces_(faces), tolerance_(tolerance), settled_(faces.triangles.size()) {}

  Index match() {
    std::vector<CutQuad> quads = find_quads();
    sort_by(std::span(quads), [](const CutQuad& a, const CutQuad& b) {
      return a.points != b.points ? a.points < b.points : a.diagonal < b.diagonal;
    });
    Index matched = 0;
    for (auto first = quads.begin(); first != quads.end();) {
      auto last = first;
      while (last != quads.end() && last->points == first->points) ++last;
      matched +=
          match_group(std::span<const CutQuad>(&*first, static_cast<std::size_t>(last - first)));
      first = last;
    }
    return matched;
  }

 private:
  SideId opposite(SideId side) const { return faces_.topology.opposite[side]; }
  PointId start(SideId side) const { return faces_.triangles[triangle_of(side)][corner_of(side)]; }
  PointId apex(SideId side) const { return start(previous_side(side)); }

  std::vector<CutQuad> find_quads() const {
    Marks shared(faces_.topology.opposite.size());
    for (const SideId side : faces_.topology.non_manifold_sides) shared.set(side);
    std::vector<SideId> inner;  // by the lower one of two, next to sides that others share
    for (const SideId outer : faces_.topology.non_manifold_sides) {
      for (const SideId side : {next_side(outer), previous_side(outer)}) {
        if (opposite(side) == kNone || shared.test(side)) continue;
        inner.push_back(std::min(side, opposite(side)));
      }
    }
    make_set(inner);
    std::vector<CutQuad> quads;
    for (const SideId side : inner) {
      const SideId beyond = opposite(side);
      if (apex(side) == apex(beyond)) continue;
      CutQuad quad{{start(side), start(next_side(side)), apex(side), apex(beyond)}, side};
      std::sort(quad.points.begin(), quad.points.end());
      quads.push_back(quad);
    }
    return quads;
  }

  Index match_group(std::span<const CutQuad> quads) {
    const auto is_left = [this](const CutQuad& quad) {
      return !settled_.test(triangle_of(quad.diagonal)) &&
             !settled_.test(triangle_of(opposite(quad.diagonal)));
    };
    // Triangles that meet at an angle are no quad: they are faces of a thin body, or a front and a
    // back that meet at a rim, or were cut along the diagonal outside of a quad that is not convex.
    const auto first = std::find_if(quads.begin(), quads.end(), [&](const CutQuad& quad) {
      return is_left(quad) && is_flat(quad.diagonal);
    });
    if (first == quads.end() || gap(first->diagonal) > tolerance_) return 0;
    const SideId model = first->diagonal;
    const auto differs = [&](const CutQuad& quad) {
      return is_left(quad) && runs_across(model, quad.diagonal);
    };
    Index matched = 0;
    for (const CutQuad& quad : quads) {
      if (!differs(quad)) continue;
      turn_diagonal(quad.diagonal);
      settle(quad.diagonal);
      ++matched;
    }
    if (matched > 0) settle(model);
    return matched;
  }

  void settle(SideId diagonal) {
    settled_.set(triangle_of(diagonal));
    settled_.set(triangle_of(opposite(diagonal)));
  }

  // Tells whether the diagonals of two quads over the same points are different ones, with the same
  // four outer edges.
  bool runs_across(SideId a, SideId b) const {
    const PointId from = apex(a);
    const PointId to = apex(opposite(a));
    return (start(b) == from && start(next_side(b)) == to) ||
           (start(b) == to && start(next_side(b)) == from);
  }

  // Returns how far the lines of the quad's two diagonals are apart; infinite if they are parallel.
  double gap(SideId diagonal) const {
    const Vec3& a = faces_.points[start(diagonal)];
    const Vec3& b = faces_.points[apex(opposite(diagonal))];
    const Vec3 across =
        (faces_.points[start(next_side(diagonal))] - a).cross(faces_.points[apex(diagonal)] - b);
    const double length = across.norm();
    return length > 0 ? std::abs(across.dot(b - a)) / length
                      : std::numeric_limits<double>::infinity();
  }

  // Tells whether the quad's two triangles face about the same way.
  bool is_flat(SideId diagonal) const {
    const auto normal = [this](SideId side) {
      return unit_normal(faces_.points[start(side)], faces_.points[start(next_side(side))],
                         faces_.points[apex(side)]);
    };
    return normal(diagonal).dot(normal(opposite(diagonal))) > kFlat;
  }

  // Cuts the quad along its other diagonal.
  void turn_diagonal(SideId diagonal) {
    const SideId beyond = opposite(diagonal);
    const PointId from = start(diagonal);
    const PointId to = start(next_side(diagonal));
    const PointId left = apex(diagonal);
    const PointId right = apex(beyond);
    faces_.triangles[triangle_of(diagonal)] = {from, right, left};
    faces_.triangles[triangle_of(beyond)] = {right, to, left};
  }

  InputFaces& faces_;
  double tolerance_;
  Marks settled_;  // triangles of quads that were matched
};

}  // namespace

Index match_diagonals(InputFaces& faces, double tolerance) {
  if (faces.topology.non_manifold_sides.empty()) return 0;
  return Diagonals(faces, tolerance).match();
}

}  // namespace kdm
