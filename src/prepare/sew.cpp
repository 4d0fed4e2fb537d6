// SPDX-License-Identifier: MIT
// Finds for each rim side the nearest other one, and joins sides that have found each other.
//
// Only rim sides are joined, and only as a whole: so parts that lie close to each other stay apart,
// and no triangle shrinks because it is small. Lengths are measured by the largest difference of
// coordinates, which neither overflows nor underflows.
#include "prepare/sew.h"

#include <algorithm>

#include "geometry/triangle.h"
#include "mesh/box_tree.h"
#include "mesh/disjoint_sets.h"
#include "mesh/edge_sides.h"
#include "mesh/marks.h"
#include "mesh/sort.h"
#include "threads/share_work.h"

namespace kdm {
namespace {

// Points that were joined may bring other sides within reach, so the search is repeated.
constexpr int kRounds = 3;
// Limits the sides that one side is compared with: thousands may lie in one place.
constexpr int kMostCandidates = 64;

// When a surface counts as torn: the share of rim sides among its edges. How far torn rims are
// sewn: the distance that nine of ten of them do not exceed, times this.
constexpr double kLeastRims = 0.2;
constexpr double kMoreThanMost = 1.5;
// The cosine of the angle by which directions differ clearly.
constexpr double kLeastTurn = 0.5;

double distance_between(const Vec3& a, const Vec3& b) { return (a - b).cwiseAbs().maxCoeff(); }

struct RimSide {
  TriangleId triangle;
  PointId from;
  PointId to;
  double reach;  // how far the ends of another side may be from its own
};

// What is known of the rim side that lies nearest to a given rim side.
struct Match {
  Index other = kNone;  // its number among the rim sides
  double distance = 0;  // between the ends that are further apart
  bool same_direction = false;
};

struct Rims {
  std::vector<RimSide> sides;
  std::size_t edges = 0;  // how many edges there are, others than rims among them
};

Rims find_rim_sides(double distance, const std::vector<Triangle>& triangles,
                    const std::vector<Vec3>& points, const Topology& topology) {
  Rims rims;
  std::size_t paired = 0;
  Marks unpaired(topology.opposite.size());  // alone, or beside a side that runs the same way
  for (SideId side = 0; side < unpaired.size(); ++side) {
    const bool is_paired = topology.opposite[side] != kNone;
    unpaired.set(side, !is_paired);
    paired += is_paired ? 1 : 0;
  }
  for (const SideId side : topology.non_manifold_sides) {
    unpaired.clear(side);
    paired -= topology.opposite[side] != kNone ? 1 : 0;
  }
  rims.edges = paired / 2 + topology.non_manifold_edges;
  const EdgeSides edges(triangles, static_cast<Index>(points.size()), unpaired);
  edges.for_each_edge([&](Index, std::span<const EdgeSide> sides) {
    ++rims.edges;
    if (sides.size() != 1) return;
    const SideId side = sides[0].side;
    const Triangle& t = triangles[triangle_of(side)];
    const PointId from = t[corner_of(side)];
    const PointId to = t[next_corner(corner_of(side))];
    const double reach = std::min(distance, 0.5 * distance_between(points[from], points[to]));
    if (reach > 0) rims.sides.push_back({triangle_of(side), from, to, reach});
  });
  return rims;
}

class MatchFinder {
 public:
  MatchFinder(const std::vector<RimSide>& rims, const std::vector<Vec3>& points)
      : rims_(rims), points_(points), boxes_(boxes_of(rims, points)), tree_(boxes_) {}

  // Returns for each side what `nearest` finds.
  std::vector<Match> matches() const {
    constexpr std::size_t kSidesPerPart = 256;
    std::vector<Match> found(rims_.size());
    share_parts(rims_.size(), kSidesPerPart, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) found[i] = nearest(static_cast<Index>(i));
    });
    return found;
  }

 private:
  // Finds the nearest of the rim sides within reach of side i; of equally near ones the one that
  // runs the other way, then the one with the lower number.
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

  // Returns a box round the middle of each side, so that the boxes of sides that belong together
  // meet: their middles are no further apart than their ends.
  static std::vector<Box> boxes_of(const std::vector<RimSide>& rims,
                                   const std::vector<Vec3>& points) {
    std::vector<Box> boxes;
    boxes.reserve(rims.size());
    for (const RimSide& rim : rims) {
      const Vec3 middle = 0.5 * points[rim.from] + 0.5 * points[rim.to];
      const Vec3 half = Vec3::Constant(0.5 * rim.reach);
      boxes.push_back({middle - half, middle + half});
    }
    return boxes;
  }

  // Returns the distance between the ends that are further apart.
  double gap(const RimSide& a, const RimSide& b, bool same_direction) const {
    return std::max(distance_between(points_[a.from], points_[same_direction ? b.from : b.to]),
                    distance_between(points_[a.to], points_[same_direction ? b.to : b.from]));
  }

  const std::vector<RimSide>& rims_;
  const std::vector<Vec3>& points_;
  std::vector<Box> boxes_;
  BoxTree tree_;
};

// Returns the unit vector that leads from a rim side into its triangle, upright on the side.
Vec3 inwards(const RimSide& rim, const std::vector<Triangle>& triangles,
             const std::vector<Vec3>& points) {
  const Triangle& t = triangles[rim.triangle];
  const Vec3 along = points[rim.to] - points[rim.from];
  Vec3 across = (points[t[0]] - points[rim.from]) + (points[t[1]] - points[rim.from]) +
                (points[t[2]] - points[rim.from]);
  const double square = along.squaredNorm();
  if (square > 0) across -= along * (along.dot(across) / square);
  return normalized_or_zero(across);
}

// Tells whether the triangles of two rim sides may have been joined along them: they are not over
// each other, and neither lies between the two sides.
bool lie_apart(const RimSide& a, const RimSide& b, const std::vector<Triangle>& triangles,
               const std::vector<Vec3>& points) {
  const Vec3 into_a = inwards(a, triangles, points);
  const Vec3 into_b = inwards(b, triangles, points);
  const Vec3 way =
      normalized_or_zero((points[b.from] + points[b.to]) - (points[a.from] + points[a.to]));
  return into_a.dot(into_b) < kLeastTurn &&
         !(into_a.dot(way) > kLeastTurn && into_b.dot(way) < -kLeastTurn);
}

// Replaces the points of each set by the one with the lowest number, and moves that to their mean.
void move_together(DisjointSets& sets, std::vector<Triangle>& triangles,
                   std::vector<Vec3>& points) {
  std::vector<Index> size(points.size(), 0);
  for (PointId p = 0; p < points.size(); ++p) ++size[sets.find(p)];
  std::vector<Vec3> means(points.size(), Vec3::Zero());
  for (PointId p = 0; p < points.size(); ++p) {
    const PointId set = sets.find(p);
    if (size[set] > 1) means[set] += points[p] / size[set];
  }
  for (PointId p = 0; p < points.size(); ++p) {
    if (size[p] > 1) points[p] = means[p];
  }
  for (Triangle& t : triangles) {
    for (Index& corner : t) corner = sets.find(corner);
  }
}

}  // namespace

Index sew_rims(double distance, std::vector<Triangle>& triangles, std::vector<Vec3>& points,
               Topology& topology) {
  Index sewn = 0;
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<RimSide> rims = find_rim_sides(distance, triangles, points, topology).sides;
    const std::vector<Match> matches = MatchFinder(rims, points).matches();
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
    topology = build_topology(triangles, static_cast<Index>(points.size()));
  }
  return sewn;
}

double torn_distance(double most, const std::vector<Triangle>& triangles,
                     const std::vector<Vec3>& points, const Topology& topology) {
  const auto [rims, edges] = find_rim_sides(most, triangles, points, topology);
  if (!(static_cast<double>(rims.size()) > kLeastRims * static_cast<double>(edges))) return 0;
  const std::vector<Match> matches = MatchFinder(rims, points).matches();
  std::vector<double> distances;
  for (Index i = 0; i < rims.size(); ++i) {
    const Index j = matches[i].other;
    if (j == kNone || matches[j].other != i) continue;
    if (lie_apart(rims[i], rims[j], triangles, points)) distances.push_back(matches[i].distance);
  }
  if (2 * distances.size() <= rims.size()) return 0;
  const std::size_t place = distances.size() * 9 / 10;
  sort_up(distances);
  return std::min(most, kMoreThanMost * distances[place]);
}

}  // namespace kdm
