// SPDX-License-Identifier: MIT
#include "split/triple_points.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "geometry/distance.h"
#include "geometry/triangle_box.h"
#include "mesh/sides.h"

namespace kdm {
namespace {

// Nothing is decided by less than this, in lattice units.
constexpr double kSure = 1;

// Where the line through a segment's ends passes a triangle.
enum class Passage { kBeside, kThrough, kUnclear };
struct Passing {
  Passage passage;
  Vec3 point = Vec3::Zero();
};

Passing pass(const std::array<Vec3, 2>& ends, const LatticeTriangle& t) {
  const std::array<Vec3, 3> corners = {to_vec3(t[0]), to_vec3(t[1]), to_vec3(t[2])};
  const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
  const double from = normal.dot(ends[0] - corners[0]);
  const double to = normal.dot(ends[1] - corners[0]);
  if (std::min(from, to) > kSure || std::max(from, to) < -kSure) return {Passage::kBeside};
  if (std::min(std::abs(from), std::abs(to)) < kSure) return {Passage::kUnclear};
  const Vec3 point = ends[0] + from / (from - to) * (ends[1] - ends[0]);
  double inwards = kLatticeSize;
  for (int i = 0; i < 3; ++i) {
    const Vec3 side = corners[next_corner(i)] - corners[i];
    inwards = std::min(inwards, normal.dot(side.cross(point - corners[i])) / side.norm());
  }
  if (inwards < -kSure) return {Passage::kBeside};
  const double to_end = std::min((point - ends[0]).norm(), (point - ends[1]).norm());
  if (inwards < kSure || to_end < kSure) return {Passage::kUnclear};
  return {Passage::kThrough, point};
}

// Tells whether the corners of a cube that have the given answer hang together along its edges.
bool hang_together(const std::array<bool, 8>& inside, bool answer) {
  unsigned left = 0;
  for (unsigned i = 0; i < 8; ++i) left |= inside[i] == answer ? 1u << i : 0;
  unsigned reached = left & (~left + 1);
  for (int steps = 0; steps < 8; ++steps) {
    for (unsigned i = 0; i < 8; ++i) {
      if ((reached >> i & 1) == 0) continue;
      reached |= (1u << (i ^ 1u) | 1u << (i ^ 2u) | 1u << (i ^ 4u)) & left;
    }
  }
  return reached == left;
}

}  // namespace

bool only_these_are_near(const CellTriangles& members, std::span<const MemberId> these,
                         const Vec3& point) {
  for (MemberId m = 0; m < members.size(); ++m) {
    const LatticeTriangle& t = members.corners(m);
    if (squared_distance(point, to_vec3(t[0]), to_vec3(t[1]), to_vec3(t[2])) > kSure) continue;
    const bool known = std::any_of(these.begin(), these.end(), [&](MemberId other) {
      return m == other || lie_on_each_other(members.corners(other), t);
    });
    if (!known) return false;
  }
  return true;
}

void TriplePoints::start(const CellSurface& cell, std::span<const CrossingPair> pairs) {
  cell_ = &cell;
  crossed_by_.clear();
  for (const CrossingPair& pair : pairs) {
    crossed_by_.insert(crossed_by_.end(), {pair, {pair[1], pair[0]}});
  }
  std::sort(crossed_by_.begin(), crossed_by_.end());
}

bool TriplePoints::find(const CrossingSegment& segment, std::vector<TriplePoint>& found) const {
  const auto& [first, second] = segment.members;
  auto pair = std::lower_bound(crossed_by_.begin(), crossed_by_.end(), CrossingPair{first, 0});
  for (; pair != crossed_by_.end() && (*pair)[0] == first; ++pair) {
    const MemberId third = (*pair)[1];
    const PieceId piece = cell_->pieces.piece_of(third);
    if (piece == segment.pieces[0] || piece == segment.pieces[1]) continue;
    if (!std::binary_search(crossed_by_.begin(), crossed_by_.end(), CrossingPair{second, third})) {
      continue;
    }
    const Passing passing = pass(segment.ends, cell_->triangles.corners(third));
    if (passing.passage == Passage::kUnclear) return false;
    if (passing.passage == Passage::kBeside) continue;
    std::array<std::pair<PieceId, MemberId>, 3> three = {
        {{segment.pieces[0], first}, {segment.pieces[1], second}, {piece, third}}};
    std::sort(three.begin(), three.end());
    found.push_back({{three[0].first, three[1].first, three[2].first},
                     {three[0].second, three[1].second, three[2].second},
                     passing.point});
  }
  return true;
}

bool TriplePoints::bounds_a_disk(const TriplePoint& point) const {
  const CellTriangles& members = cell_->triangles;
  if (!only_these_are_near(members, point.members, point.point)) return false;
  const LatticePoint beside = nearest_point_in(members.cell(), point.point);
  const int state = states_.at(beside);
  std::array<bool, 8> inside{};
  for (unsigned beyond = 0; beyond < 8; ++beyond) {
    int there = state;
    for (unsigned i = 0; i < 3; ++i) {
      if ((beyond >> i & 1) == 0) continue;
      const bool before = lies_before(members.corners(point.members[i]), beside);
      there = states_.beyond(point.members[i], there, !before);
    }
    inside[beyond] = states_.is_inside(there);
  }
  return hang_together(inside, true) && hang_together(inside, false);
}

}  // namespace kdm
