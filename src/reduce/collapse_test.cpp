// SPDX-License-Identifier: MIT
#include "reduce/collapse_test.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reduce/shape.h"

namespace kdm {
namespace {

// A triangle may turn by some 78 degrees in one step.
constexpr double kLeastCosine = 0.2;
// Triangles that are turned by more than some 45 degrees make a fold.
constexpr double kFolded = 0.7;

// Tells whether some triangle of the ring, as it is or as it would be, is turned by more than some
// 45 degrees against the mean of those that there would be.
bool is_folded(const CollapseRing& ring) {
  Vec3 mean = Vec3::Zero();
  for (const RingTriangle& t : ring.triangles) mean += t.after.doubled_area * t.after.normal;
  const double least = kFolded * kFolded * mean.squaredNorm();
  const auto is_turned = [&](const Vec3& normal) {
    const double along = normal.dot(mean);
    return !(along > 0 && along * along >= least);
  };
  return std::any_of(ring.triangles.begin(), ring.triangles.end(), [&](const RingTriangle& t) {
    return is_turned(t.after.normal) || is_turned(t.before.normal);
  });
}

}  // namespace

CollapseTest::CollapseTest(Workpiece& piece, const EdgeErrors& errors, const KeptLines& lines)
    : piece_(piece), errors_(errors), lines_(lines), seen_(piece.positions.size(), 0) {
  if (piece.distance) smooth_.emplace(piece, *piece.distance->creases);
  if (piece.guard) crossing_.emplace(piece.mesh);
}

bool CollapseTest::meets_link_condition(SideId edge) {
  const SideId back = piece_.mesh.opposite(edge);
  ++stamp_;
  piece_.mesh.for_each_neighbour(piece_.mesh.start(edge), [&](VertexId v) { seen_[v] = stamp_; });
  int common = 0;
  piece_.mesh.for_each_neighbour(piece_.mesh.end(edge),
                                 [&](VertexId v) { common += seen_[v] == stamp_ ? 1 : 0; });
  if (back == kNone) {
    // Of a single triangle nothing would be left.
    return common == 1 && (piece_.mesh.opposite(next_side(edge)) != kNone ||
                           piece_.mesh.opposite(previous_side(edge)) != kNone);
  }
  if (common != 2) return false;
  // Of a tetrahedron nothing would be left.
  const VertexId tip = piece_.mesh.start(previous_side(edge));
  int round_tip = 0;
  piece_.mesh.for_each_leaving(tip, [&](SideId) { ++round_tip; });
  if (round_tip > 3 || piece_.mesh.on_boundary(tip)) return true;
  const VertexId other = piece_.mesh.start(previous_side(back));
  bool joined = false;
  piece_.mesh.for_each_neighbour(tip, [&](VertexId v) { joined = joined || v == other; });
  return !joined;
}

void CollapseTest::make_ring(SideId edge, const Vec3& point, CollapseRing& ring) const {
  const SideId back = piece_.mesh.opposite(edge);
  ring.kept = piece_.mesh.start(edge);
  ring.removed = piece_.mesh.end(edge);
  ring.triangles.clear();
  ring.gone = {triangle_of(edge)};
  if (back != kNone) ring.gone.push_back(triangle_of(back));
  for (const VertexId v : {ring.kept, ring.removed}) {
    piece_.mesh.for_each_leaving(v, [&](SideId h) {
      const TriangleId t = triangle_of(h);
      if (t == ring.gone.front() || t == ring.gone.back()) return;
      const VertexId from = piece_.mesh.end(h);
      const VertexId to = piece_.mesh.start(previous_side(h));
      const SideId beyond = piece_.mesh.opposite(next_side(h));
      ring.triangles.push_back({t, from, to, beyond == kNone ? kNone : triangle_of(beyond),
                                piece_.positions[from], piece_.positions[to], piece_.positions[v],
                                piece_.faces[t]});
    });
  }
  put_vertex(ring, point);
}

bool CollapseTest::keeps_shape(const CollapseRing& ring) const {
  double worst = 1;
  double worst_before = 1;
  const double least_height = piece_.distance ? std::min(piece_.distance->limits[ring.kept],
                                                         piece_.distance->limits[ring.removed])
                                              : std::numeric_limits<double>::infinity();
  for (const RingTriangle& t : ring.triangles) {
    // The normal of a sliver says little.
    if (t.before.shape >= kLeastShape && t.before.normal.dot(t.after.normal) < kLeastCosine) {
      return false;
    }
    // The sides of a thin plate are long and low: what is higher than the distance kept is no
    // sliver.
    const double height = std::sqrt(t.after.doubled_area * t.after.shape);
    if (height < least_height) worst = std::min(worst, t.after.shape);
    worst_before = std::min(worst_before, t.before.shape);
  }
  return worst >= kLeastShape || worst >= worst_before;
}

// Tells whether the step is to be held against the rest of the mesh.
bool CollapseTest::is_guarded(const CollapseRing& ring) {
  if (!piece_.guard) return false;
  if (!piece_.guarded) return true;
  const Marks& marked = *piece_.guarded;
  return marked.test(ring.kept) || marked.test(ring.removed) ||
         std::any_of(ring.triangles.begin(), ring.triangles.end(),
                     [&](const RingTriangle& t) { return marked.test(t.from); }) ||
         (piece_.distance && is_folded(ring) &&
          !piece_.guard->is_simple_all_round(ring, *crossing_));
}

bool CollapseTest::fits(SideId edge, CollapseTrial& trial) {
  const CollapseRing& ring = trial.ring;
  if (!keeps_shape(ring)) return false;
  if (piece_.distance) {
    if (!smooth_->stays_smooth(ring) || !stays_near(piece_, ring, trial.near)) return false;
    const std::vector<double>& limits = piece_.distance->limits;
    const double limit = std::min(limits[ring.kept], limits[ring.removed]);
    if (!lines_.stay_near(edge, ring, limit, trial.cut)) return false;
  }
  return !is_guarded(ring) || !piece_.guard->would_meet(ring, *crossing_);
}

void CollapseTest::run(SideId edge, CollapsePlace place, CollapseTrial& trial) {
  trial.near.near = kNone;
  if (piece_.is_held(piece_.mesh.start(edge)) || piece_.is_held(piece_.mesh.end(edge))) {
    trial.verdict = CollapseTrial::Verdict::kBeyond;
    return;
  }
  if (!meets_link_condition(edge) || lines_.would_merge(edge)) {
    trial.verdict = CollapseTrial::Verdict::kNever;
    return;
  }
  make_ring(edge, errors_.point_of(edge, place, errors_.quadric_of(edge)), trial.ring);
  if (!piece_.may_hold(trial.ring.point)) {
    trial.verdict = CollapseTrial::Verdict::kBeyond;
    return;
  }
  trial.verdict =
      fits(edge, trial) ? CollapseTrial::Verdict::kFits : CollapseTrial::Verdict::kNoPlace;
}

}  // namespace kdm
