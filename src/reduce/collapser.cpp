// SPDX-License-Identifier: MIT
// The loop over candidates.
#include "reduce/collapser.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace kdm {
namespace {

using Verdict = CollapseTrial::Verdict;

// Weight of an edge's length beside the error: among edges of flat parts the short ones go first.
constexpr double kLengthWeight = 1e-4;
// Edges are not tried whose mean squared distance to the planes is more than this many times that
// allowed.
constexpr double kHopeless = 2;
// Where the planes are off by no more than this part of the distance allowed, the surface is flat.
constexpr double kFlat = 0.3;
constexpr Index kStepsPerReport = 1024;

}  // namespace

CollapseState first_state(const Workpiece& piece) {
  return {plane_quadrics(piece), Marks(3 * std::size_t{piece.mesh.triangles()})};
}

Collapser::Collapser(Workpiece& piece, CollapseState state)
    : piece_(piece),
      lines_(piece),
      errors_(piece, std::move(state.quadrics)),
      version_(3 * std::size_t{piece.mesh.triangles()}, 0),
      failed_(std::move(state.failed)),
      waiting_(version_.size()),
      test_(piece, errors_, lines_) {
  for (SideId h = 0; h < version_.size(); ++h) {
    if (piece_.mesh.is_edge(h) && !failed_.test(h)) consider(h);
  }
}

double Collapser::limit_of(SideId edge) const {
  const std::vector<double>& limits = piece_.distance->limits;
  return std::min(limits[piece_.mesh.start(edge)], limits[piece_.mesh.end(edge)]);
}

void Collapser::push(SideId edge, CollapsePlace place) {
  const ErrorQuadric sum = errors_.quadric_of(edge);
  const double error = errors_.error(sum, errors_.point_of(edge, place, sum));
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
  if (piece_.is_edge_fixed(edge)) return;
  const std::optional<CollapsePlace> place = lines_.place_of(edge);
  if (place) push(edge, *place);
}

void Collapser::step(SideId edge, const CollapseTrial& trial) {
  const CollapseRing& ring = trial.ring;
  const VertexId v = ring.kept;
  if (piece_.distance) {
    piece_.distance->samples.move(ring, trial.near.places);
    std::vector<double>& limits = piece_.distance->limits;
    limits[v] = std::min(limits[v], limits[ring.removed]);
  }
  lines_.collapsing(edge, ring, trial.cut);
  piece_.mesh.collapse(edge);
  piece_.positions[v] = ring.point;
  errors_.join(v, ring.removed);
  piece_.joined_to[ring.removed] = v;
  for (const TriangleId t : ring.gone) piece_.changed(t);
  for (const RingTriangle& t : ring.triangles) piece_.changed(t.number);
  if (piece_.guarded && piece_.guarded->test(ring.removed)) piece_.guarded->set(v);
  ++collapses_;
  piece_.mesh.for_each_edge(v, [&](SideId changed) {
    ++version_[changed];
    consider(changed);
  });
  // Edges that had no place may have one now that their surroundings have changed.
  const bool on_rim = piece_.mesh.on_boundary(v);
  for (const RingTriangle& t : ring.triangles) {
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
  const ErrorQuadric sum = errors_.quadric_of(edge);
  const double limit = kFlat * limit_of(edge);
  for (const VertexId v : {piece_.mesh.start(edge), piece_.mesh.end(edge)}) {
    if (errors_.error(sum, piece_.positions[v]) <= limit * limit * sum.weight()) return true;
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
    if (!is_current(next)) continue;
    if (steps++ % kStepsPerReport == 0) between();
    test_.run(edge, next.place, trial_);
    if (trial_.near.near != kNone) piece_.distance->near[trial_.ring.kept] = trial_.near.near;
    if (trial_.verdict == Verdict::kFits) {
      step(edge, trial_);
      continue;
    }
    if (trial_.verdict == Verdict::kBeyond) continue;
    failed_.set(edge);
    if (trial_.verdict == Verdict::kNever || next.place != CollapsePlace::kBest) continue;
    push(edge, CollapsePlace::kStart);
    push(edge, CollapsePlace::kEnd);
    push(edge, CollapsePlace::kMiddle);
  }
}

}  // namespace kdm
