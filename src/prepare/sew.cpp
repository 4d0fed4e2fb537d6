// SPDX-License-Identifier: MIT
// Cracks: sides that face each other across next to nothing.
//
// Only rims are joined, and only whole sides: so parts that lie close to each other stay apart, and
// no triangle shrinks because it is small. Largest coordinate differences stand for lengths: they
// neither overflow nor underflow.
#include "prepare/sew.h"

#include <algorithm>

#include "mesh/box_tree.h"
#include "mesh/disjoint_sets.h"
#include "mesh/edge_sides.h"

namespace kdm {
namespace {

// Corners moved together bring other sides within reach.
constexpr int kRounds = 3;
// No more sides are compared with one: thousands may lie in one place.
constexpr int kMostCandidates = 64;

double distance_between(const Vec3& a, const Vec3& b) { return (a - b).cwiseAbs().maxCoeff(); }

struct Rim {
  Index triangle;
  Index from;
  Index to;
  double reach;  // how far ends may be apart
};

struct Match {
  Index other = kNone;
  double distance = 0;
  bool same_direction = false;
};

std::vector<Rim> find_rims(double distance, const std::vector<Triangle>& triangles,
                           const std::vector<Vec3>& points) {
  std::vector<Rim> rims;
  const EdgeSides edges(triangles, static_cast<Index>(points.size()));
  edges.for_each_edge([&](Index, std::span<const EdgeSide> sides) {
    if (sides.size() != 1) return;
    const Index side = sides[0].side;
    const Triangle& t = triangles[side / 3];
    const Index from = t[side % 3];
    const Index to = t[next_corner(static_cast<int>(side % 3))];
    const double reach = std::min(distance, 0.5 * distance_between(points[from], points[to]));
    if (reach > 0) rims.push_back({side / 3, from, to, reach});
  });
  return rims;
}

class Sewing {
 public:
  Sewing(const std::vector<Rim>& rims, const std::vector<Vec3>& points)
      : rims_(rims), points_(points), boxes_(boxes_of(rims, points)), tree_(boxes_) {}

  // Of the sides within reach the nearest; of equally near ones that which runs the other way.
  Match nearest(Index i) const {
    Match best;
    int candidates = 0;
    const auto is_better = [&](double distance, bool same_direction, Index j) {
      if (best.other == kNone || distance != best.distance) {
        return best.other == kNone || distance < best.distance;
      }
      return same_direction != best.same_direction ? best.same_direction : j < best.other;
    };
    tree_.any_meeting(boxes_[i], [&](Index j) {
      if (rims_[j].triangle == rims_[i].triangle) return false;
      for (const bool same_direction : {false, true}) {
        const double distance = gap(rims_[i], rims_[j], same_direction);
        if (distance > std::min(rims_[i].reach, rims_[j].reach)) continue;
        if (is_better(distance, same_direction, j)) best = {j, distance, same_direction};
      }
      return ++candidates == kMostCandidates;
    });
    return best;
  }

 private:
  // Middles of sides that belong together are no further apart than their ends.
  static std::vector<Box> boxes_of(const std::vector<Rim>& rims, const std::vector<Vec3>& points) {
    std::vector<Box> boxes;
    boxes.reserve(rims.size());
    for (const Rim& rim : rims) {
      const Vec3 middle = 0.5 * points[rim.from] + 0.5 * points[rim.to];
      const Vec3 half = Vec3::Constant(0.5 * rim.reach);
      boxes.push_back({middle - half, middle + half});
    }
    return boxes;
  }

  double gap(const Rim& a, const Rim& b, bool same_direction) const {
    return std::max(distance_between(points_[a.from], points_[same_direction ? b.from : b.to]),
                    distance_between(points_[a.to], points_[same_direction ? b.to : b.from]));
  }

  const std::vector<Rim>& rims_;
  const std::vector<Vec3>& points_;
  std::vector<Box> boxes_;
  BoxTree tree_;
};

// Gives all corners of a set its lowest number, and that the mean of their positions.
void move_together(DisjointSets& sets, std::vector<Triangle>& triangles,
                   std::vector<Vec3>& points) {
  std::vector<Index> size(points.size(), 0);
  for (Index p = 0; p < points.size(); ++p) ++size[sets.find(p)];
  std::vector<Vec3> means(points.size(), Vec3::Zero());
  for (Index p = 0; p < points.size(); ++p) {
    const Index set = sets.find(p);
    if (size[set] > 1) means[set] += points[p] / size[set];
  }
  for (Index p = 0; p < points.size(); ++p) {
    if (size[p] > 1) points[p] = means[p];
  }
  for (Triangle& t : triangles) {
    for (Index& corner : t) corner = sets.find(corner);
  }
}

}  // namespace

Index sew_rims(double distance, std::vector<Triangle>& triangles, std::vector<Vec3>& points) {
  Index sewn = 0;
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<Rim> rims = find_rims(distance, triangles, points);
    const Sewing sewing(rims, points);
    std::vector<Match> matches;
    matches.reserve(rims.size());
    for (Index i = 0; i < rims.size(); ++i) matches.push_back(sewing.nearest(i));
    DisjointSets sets(points.size());
    const Index before = sewn;
    for (Index i = 0; i < rims.size(); ++i) {
      const Index j = matches[i].other;
      if (j == kNone || j < i || matches[j].other != i) continue;
      const bool same = matches[i].same_direction;
      sets.join(rims[i].from, same ? rims[j].from : rims[j].to);
      sets.join(rims[i].to, same ? rims[j].to : rims[j].from);
      ++sewn;
    }
    if (sewn == before) break;
    move_together(sets, triangles, points);
  }
  return sewn;
}

}  // namespace kdm
