// SPDX-License-Identifier: MIT
// The loop over candidates, and the tests in order of what they cost.
#include "reduce/collapser.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/triangle.h"
#include "mesh/boxes.h"
#include "reduce/near_test.h"
#include "reduce/shape.h"

namespace kdm {
namespace {

// Weight of an edge's length beside the error: among edges of flat parts the short ones go first.
constexpr double kLengthWeight = 1e-4;
// Distances to planes count as equal if they differ by less than 1e-5 of the edge's length.
constexpr double kAsGood = 1e-10;
// Edges are not tried whose mean squared distance to the planes is more than this many times that
// allowed.
constexpr double kHopeless = 2;
// A triangle may turn by some 78 degrees in one step.
constexpr double kLeastCosine = 0.2;
// Where the planes are off by no more than this part of the distance allowed, the surface is flat.
constexpr double kFlat = 0.3;
// Triangles that are turned by more than some 45 degrees make a fold.
constexpr double kFolded = 0.7;
constexpr Index kStepsPerReport = 1024;

Vec3 rounded_to_single(const Vec3& p) { return p.cast<float>().cast<double>(); }

Vec3 centre_of_all(const std::vector<Vec3>& positions) {
  Box box;
  for (const Vec3& p : positions) grow(box, p);
  return centre_of(box);
}

}  // namespace

Collapser::Collapser(Workpiece& piece)
    : piece_(piece),
      lines_(piece),
      quadric_(piece.positions.size()),
      centre_(centre_of_all(piece.positions)),
      version_(3 * std::size_t{piece.mesh.triangles()}, 0),
      failed_(version_.size()),
      waiting_(version_.size()),
      seen_(piece.positions.size(), 0) {
  if (piece.distance) smooth_.emplace(piece, piece.distance->creases);
  add_quadrics();
  if (lines_.any()) add_line_quadrics();
  for (SideId h = 0; h < version_.size(); ++h) {
    if (piece_.mesh.is_edge(h)) consider(h);
  }
}

void Collapser::add_quadrics() {
  for (TriangleId t = 0; t < piece_.mesh.triangles(); ++t) {
    const Triangle c = piece_.mesh.corners(t);
    const Vec3 a = piece_.positions[c[0]] - centre_;
    const Vec3 doubled =
        doubled_area_vector(a, piece_.positions[c[1]] - centre_, piece_.positions[c[2]] - centre_);
    const double length = doubled.norm();
    if (!(length > 0)) continue;
    const Vec3 normal = doubled / length;
    for (const VertexId v : c) quadric_[v].add_plane(normal, normal.dot(a), length);
  }
}

// Planes through the lines, perpendicular to the triangles beside them, hold vertices there as
// those of triangles do on the surface.
void Collapser::add_line_quadrics() {
  for (SideId h = 0; h < version_.size(); ++h) {
    const TriangleId t = triangle_of(h);
    if (piece_.mesh.is_removed(t) || !lines_.is_line(h)) continue;
    const Triangle c = piece_.mesh.corners(t);
    const Vec3 start = piece_.positions[piece_.mesh.start(h)] - centre_;
    const Vec3 along = piece_.positions[piece_.mesh.end(h)] - centre_ - start;
    const Vec3 across = normalized_or_zero(along.cross(
        unit_normal(piece_.positions[c[0]], piece_.positions[c[1]], piece_.positions[c[2]])));
    if (across.isZero()) continue;
    for (const VertexId v : {piece_.mesh.start(h), piece_.mesh.end(h)}) {
      quadric_[v].add_plane(across, across.dot(start), along.squaredNorm());
    }
  }
}

Vec3 Collapser::point_of(SideId edge, CollapsePlace place, const ErrorQuadric& sum) const {
  const Vec3& start = piece_.positions[piece_.mesh.start(edge)];
  const Vec3& end = piece_.positions[piece_.mesh.end(edge)];
  if (place == CollapsePlace::kStart) return start;
  if (place == CollapsePlace::kEnd) return end;
  const Vec3 middle = 0.5 * (start + end);
  if (place == CollapsePlace::kMiddle) return rounded_to_single(middle);
  // An end that is as good stays where it is: so corners and edges of flat parts stay exact.
  const Vec3 best = sum.minimiser(middle - centre_);
  const double good = sum.error(best) + sum.weight() * kAsGood * (end - start).squaredNorm();
  const double at_start = sum.error(start - centre_);
  const double at_end = sum.error(end - centre_);
  if (std::min(at_start, at_end) <= good) return at_start <= at_end ? start : end;
  return rounded_to_single(best + centre_);
}

ErrorQuadric Collapser::quadric_of(SideId edge) const {
  ErrorQuadric sum = quadric_[piece_.mesh.start(edge)];
  sum += quadric_[piece_.mesh.end(edge)];
  return sum;
}

double Collapser::limit_of(SideId edge) const {
  const std::vector<double>& limits = piece_.distance->limits;
  return std::min(limits[piece_.mesh.start(edge)], limits[piece_.mesh.end(edge)]);
}

void Collapser::push(SideId edge, CollapsePlace place) {
  const ErrorQuadric sum = quadric_of(edge);
  const double error = sum.error(point_of(edge, place, sum) - centre_);
  // Where the planes are much further off than allowed on average, the surface is too.
  if (piece_.distance) {
    const double limit = limit_of(edge);
    if (error > kHopeless * limit * limit * sum.weight()) return;
  }
  const Vec3 along =
      piece_.positions[piece_.mesh.end(edge)] - piece_.positions[piece_.mesh.start(edge)];
  double cost = error + kLengthWeight * sum.weight() * along.squaredNorm();
  // Nothing else bounds the distance of small areas: what is far off costs more there than by area.
  if (!piece_.distance && sum.weight() > 0) cost /= std::sqrt(sum.weight());
  queue_.push({static_cast<float>(cost), edge, version_[edge], place});
}

void Collapser::consider(SideId edge) {
  failed_.clear(edge);
  const std::optional<CollapsePlace> place = lines_.place_of(edge);
  if (place) push(edge, *place);
}

bool Collapser::meets_link_condition(SideId edge) {
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

void Collapser::make_ring(SideId edge, const Vec3& point) {
  const SideId back = piece_.mesh.opposite(edge);
  ring_.kept = piece_.mesh.start(edge);
  ring_.removed = piece_.mesh.end(edge);
  ring_.point = point;
  ring_.triangles.clear();
  ring_.gone = {triangle_of(edge)};
  if (back != kNone) ring_.gone.push_back(triangle_of(back));
  for (const VertexId v : {ring_.kept, ring_.removed}) {
    piece_.mesh.for_each_leaving(v, [&](SideId h) {
      const TriangleId t = triangle_of(h);
      if (t == ring_.gone.front() || t == ring_.gone.back()) return;
      const VertexId from = piece_.mesh.end(h);
      const VertexId to = piece_.mesh.start(previous_side(h));
      const SideId beyond = piece_.mesh.opposite(next_side(h));
      ring_.triangles.push_back({t, from, to, beyond == kNone ? kNone : triangle_of(beyond),
                                 piece_.positions[from], piece_.positions[to],
                                 piece_.positions[v]});
    });
  }
}

bool Collapser::keeps_shape() const {
  double worst = 1;
  double worst_before = 1;
  const double least_height = piece_.distance ? std::min(piece_.distance->limits[ring_.kept],
                                                         piece_.distance->limits[ring_.removed])
                                              : std::numeric_limits<double>::infinity();
  for (const RingTriangle& t : ring_.triangles) {
    const Vec3 before = doubled_area_vector(t.old_point, t.from_point, t.to_point);
    const Vec3 after = doubled_area_vector(ring_.point, t.from_point, t.to_point);
    const double size_before = before.norm();
    const double size = after.norm();
    const double shape_before = shape_of(t.old_point, t.from_point, t.to_point, size_before);
    const double shape = shape_of(ring_.point, t.from_point, t.to_point, size);
    // The normal of a sliver says little.
    if (shape_before >= kLeastShape && before.dot(after) < kLeastCosine * size_before * size) {
      return false;
    }
    // The sides of a thin plate are long and low: what is higher than the distance kept is no
    // sliver.
    const double height = size > 0 ? std::sqrt(size * shape) : 0;
    if (height < least_height) worst = std::min(worst, shape);
    worst_before = std::min(worst_before, shape_before);
  }
  return worst >= kLeastShape || worst >= worst_before;
}

// Tells whether some triangle of the ring, as it is or as it would be, is turned by more than some
// 45 degrees against the mean of those that there would be.
bool Collapser::is_folded() const {
  Vec3 mean = Vec3::Zero();
  for (const RingTriangle& t : ring_.triangles) {
    mean += doubled_area_vector(ring_.point, t.from_point, t.to_point);
  }
  const double least = kFolded * kFolded * mean.squaredNorm();
  const auto is_turned = [&](const Vec3& area) {
    const double along = area.dot(mean);
    return !(along > 0 && along * along >= least * area.squaredNorm());
  };
  return std::any_of(ring_.triangles.begin(), ring_.triangles.end(), [&](const RingTriangle& t) {
    return is_turned(doubled_area_vector(ring_.point, t.from_point, t.to_point)) ||
           is_turned(doubled_area_vector(t.old_point, t.from_point, t.to_point));
  });
}

// Tells whether the step is to be held against the rest of the mesh.
bool Collapser::is_guarded() const {
  if (!piece_.guard) return false;
  if (!piece_.guarded) return true;
  const Marks& marked = *piece_.guarded;
  return marked.test(ring_.kept) || marked.test(ring_.removed) ||
         std::any_of(ring_.triangles.begin(), ring_.triangles.end(),
                     [&](const RingTriangle& t) { return marked.test(t.from); }) ||
         (piece_.distance && is_folded());
}

Collapser::Verdict Collapser::try_step(SideId edge, CollapsePlace place) {
  if (!meets_link_condition(edge) || lines_.would_merge(edge)) return Verdict::kNever;
  make_ring(edge, point_of(edge, place, quadric_of(edge)));
  if (!keeps_shape()) return Verdict::kNoPlace;
  if (smooth_ && !smooth_->stays_smooth(ring_)) return Verdict::kNoPlace;
  if (piece_.distance && !stays_near(piece_, ring_)) return Verdict::kNoPlace;
  if (piece_.distance && !lines_.stay_near(edge, ring_, limit_of(edge))) return Verdict::kNoPlace;
  if (is_guarded() && piece_.guard->would_meet(ring_)) return Verdict::kNoPlace;
  step(edge);
  return Verdict::kDone;
}

void Collapser::step(SideId edge) {
  const VertexId v = ring_.kept;
  if (piece_.distance) {
    piece_.distance->samples.move(ring_);
    std::vector<double>& limits = piece_.distance->limits;
    limits[v] = std::min(limits[v], limits[ring_.removed]);
  }
  lines_.collapsing(edge, ring_);
  piece_.mesh.collapse(edge);
  piece_.positions[v] = ring_.point;
  quadric_[v] += quadric_[ring_.removed];
  piece_.joined_to[ring_.removed] = v;
  if (piece_.guard) piece_.guard->collapsed(ring_);
  if (piece_.guarded && piece_.guarded->test(ring_.removed)) piece_.guarded->set(v);
  ++collapses_;
  piece_.mesh.for_each_edge(v, [&](SideId changed) {
    ++version_[changed];
    consider(changed);
  });
  // Edges that had no place may have one now that their surroundings have changed.
  const bool on_rim = piece_.mesh.on_boundary(v);
  for (const RingTriangle& t : ring_.triangles) {
    retry_edges_at(t.from);
    if (on_rim) retry_edges_at(t.to);
  }
}

void Collapser::retry_edges_at(VertexId v) {
  piece_.mesh.for_each_edge(v, [&](SideId edge) {
    if (!failed_.test(edge)) return;
    // Within a distance most fail again, so they wait until no other edge is left. On lines and in
    // flat parts, which go first, few do.
    if (!piece_.distance || lines_.is_line(edge) || is_flat(edge)) {
      ++version_[edge];
      consider(edge);
    } else if (!waiting_.test_and_set(edge)) {
      waiting_edges_.push_back(edge);
    }
  });
}

bool Collapser::is_flat(SideId edge) const {
  const ErrorQuadric sum = quadric_of(edge);
  const double limit = kFlat * limit_of(edge);
  for (const VertexId v : {piece_.mesh.start(edge), piece_.mesh.end(edge)}) {
    if (sum.error(piece_.positions[v] - centre_) <= limit * limit * sum.weight()) return true;
  }
  return false;
}

// Tells whether some edge is worth another try.
bool Collapser::retry_waiting_edges() {
  for (const SideId edge : waiting_edges_) {
    waiting_.clear(edge);
    if (!failed_.test(edge) || !piece_.mesh.is_edge(edge)) continue;
    ++version_[edge];
    consider(edge);
  }
  waiting_edges_.clear();
  return !queue_.empty();
}

void Collapser::collapse_to(Index triangles, const std::function<void()>& between) {
  Index steps = 0;
  while (piece_.mesh.living_triangles() > triangles) {
    if (queue_.empty() && !retry_waiting_edges()) break;
    const Candidate next = queue_.pop();
    const SideId edge = next.edge;
    if (next.version != version_[edge] || !piece_.mesh.is_edge(edge)) continue;
    if (steps++ % kStepsPerReport == 0) between();
    const Verdict verdict = try_step(edge, next.place);
    if (verdict == Verdict::kDone) continue;
    failed_.set(edge);
    if (verdict == Verdict::kNever || next.place != CollapsePlace::kBest) continue;
    push(edge, CollapsePlace::kStart);
    push(edge, CollapsePlace::kEnd);
    push(edge, CollapsePlace::kMiddle);
  }
}

}  // namespace kdm
