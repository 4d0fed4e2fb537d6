// SPDX-License-Identifier: MIT
// Goes over all edges until nothing changes any more, a few times at most.
#include "reduce/flips.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "mesh/marks.h"
#include "reduce/near_test.h"
#include "reduce/shape.h"
#include "reduce/smooth_test.h"
#include "reduce/vertex_moves.h"
#include "threads/share_work.h"

namespace kdm {
namespace {

constexpr int kMostRounds = 4;
// Threads share sides by so many.
constexpr std::size_t kSidesPerPart = 1024;

class Flipper {
 public:
  explicit Flipper(Workpiece& piece)
      : piece_(piece),
        smooth_(piece, *piece.distance->creases),
        crossing_(piece.mesh),
        changed_(piece.positions.size(), 0),
        moved_in_vain_(piece.positions.size(), 0) {}

  Index flip_all() {
    const SideId sides = 3 * piece_.mesh.triangles();
    Index flips = 0;
    Index moves = 0;
    for (int round = 0; round < kMostRounds; ++round) {
      const Index before = flips + moves;
      round_before_ = std::exchange(round_, time_);
      for (SideId h = 0; h < sides; ++h) {
        if (!piece_.mesh.is_edge(h) || piece_.is_edge_fixed(h)) continue;
        if ((round > 0 && !has_changed(h)) || !smooth_.is_false_crease(h)) continue;
        if (flip_here(h)) {
          ++flips;
        } else if (move_here(h)) {
          ++moves;
        }
      }
      if (flips + moves == before) break;
    }
    return flips;
  }

 private:
  // Tells whether anything at the edge's two triangles has changed in this round or the one before.
  bool has_changed(SideId h) const {
    const auto at = [&](SideId side) {
      const VertexId v = piece_.mesh.start(side);
      return changed_[v] > round_before_;
    };
    const SideId back = piece_.mesh.opposite(h);
    return at(h) || at(next_side(h)) || at(previous_side(h)) ||
           (back != kNone && at(previous_side(back)));
  }

  // Flips the edge, or one of the four other edges of its triangles, if that helps.
  bool flip_here(SideId h) {
    const SideId back = piece_.mesh.opposite(h);
    for (const SideId side :
         {h, next_side(h), previous_side(h), next_side(back), previous_side(back)}) {
      if (piece_.mesh.opposite(side) != kNone && !piece_.is_border(side) && try_flip(side)) {
        return true;
      }
    }
    return false;
  }

  // Moves one of the four vertices of its triangles, if that helps.
  bool move_here(SideId h) {
    if (turns_in_reference(piece_, h)) return false;
    const SideId back = piece_.mesh.opposite(h);
    for (const SideId side : {h, back, previous_side(h), previous_side(back)}) {
      const VertexId v = piece_.mesh.start(side);
      if (piece_.is_fixed(v) || stays_in_vain(v)) continue;
      const VertexMove move = move_to_smooth(piece_, smooth_, crossing_, v);
      if (move == VertexMove::kNever) moved_in_vain_[v] = time_;
      if (move != VertexMove::kMade) continue;
      ++time_;
      changed_[v] = time_;
      piece_.mesh.for_each_neighbour(v, [&](VertexId near) { changed_[near] = time_; });
      return true;
    }
    return false;
  }

  // Tells whether moving the vertex was tried in vain, and would be again: none of its triangles,
  // or of those beside them, has changed since.
  bool stays_in_vain(VertexId v) const {
    const Index tried = moved_in_vain_[v];
    if (tried == 0 || changed_[v] > tried) return false;
    bool changed = false;
    piece_.mesh.for_each_neighbour(
        v, [&](VertexId near) { changed = changed || changed_[near] > tried; });
    return !changed;
  }

  bool try_flip(SideId h) {
    const HalfEdges& mesh = piece_.mesh;
    const SideId back = mesh.opposite(h);
    const VertexId a = mesh.start(h);
    const VertexId b = mesh.start(back);
    const VertexId c = mesh.start(previous_side(h));
    const VertexId d = mesh.start(previous_side(back));
    if (piece_.is_edge_fixed(h) || piece_.is_fixed(c) || piece_.is_fixed(d)) return false;
    bool joined = false;
    mesh.for_each_neighbour(c, [&](VertexId v) { joined = joined || v == d; });
    if (joined || c == d || !smooth_.flip_smooths(h)) return false;
    const std::array<TriangleId, 2> places = {triangle_of(h), triangle_of(back)};
    const std::array<Triangle, 2> triangles = {Triangle{a, d, c}, Triangle{b, c, d}};
    if (!keeps_shape(triangles) || !edge_stays_near(piece_, c, d)) return false;
    Samples& samples = piece_.distance->samples;
    const std::vector<double>& limits = piece_.distance->limits;
    if (!samples.fit(places, {corners(triangles[0]), corners(triangles[1])},
                     std::min({limits[a], limits[b], limits[c], limits[d]}), places_)) {
      return false;
    }
    if (piece_.guard->would_meet(places, triangles, crossing_)) return false;
    samples.move(places, places_);
    piece_.mesh.flip(h);
    ++time_;
    for (const VertexId v : {a, b, c, d}) changed_[v] = time_;
    for (const TriangleId t : places) piece_.changed(t);
    return true;
  }

  std::array<Vec3, 3> corners(const Triangle& t) const {
    return {piece_.positions[t[0]], piece_.positions[t[1]], piece_.positions[t[2]]};
  }

  bool keeps_shape(const std::array<Triangle, 2>& triangles) const {
    for (const Triangle& t : triangles) {
      const std::array<Vec3, 3> c = corners(t);
      if (face_shape(c[0], c[1], c[2]).shape < kLeastShape) return false;
    }
    return true;
  }

  Workpiece& piece_;
  SmoothTest smooth_;
  CrossingGuard::Scratch crossing_;
  Samples::Places places_;
  // Times are counted by changes.
  Index time_ = 1;
  Index round_ = 1;                   // when this round began
  Index round_before_ = 1;            // when the round before began
  std::vector<Index> changed_;        // per vertex: when something at it was last changed
  std::vector<Index> moved_in_vain_;  // per vertex: when moving it was last tried in vain; 0: never
};

}  // namespace

void find_crossing_creases(Workpiece& piece) {
  const SmoothTest smooth(piece, *piece.distance->creases);
  Marks crossing(3 * std::size_t{piece.mesh.triangles()});
  share_parts(crossing.size(), kSidesPerPart, [&](std::size_t begin, std::size_t end) {
    for (SideId h = static_cast<SideId>(begin); h < end; ++h) {
      crossing.set(
          h, piece.mesh.is_edge(h) && smooth.is_false_crease(h) && turns_in_reference(piece, h));
    }
  });
  std::vector<std::array<Vec3, 2>> segments;
  for (SideId h = 0; h < crossing.size(); ++h) {
    if (!crossing.test(h)) continue;
    segments.push_back({piece.positions[piece.mesh.start(h)], piece.positions[piece.mesh.end(h)]});
  }
  if (segments.empty()) return;
  auto creases = std::make_shared<TrueCreases>(*piece.distance->creases);
  creases->add(std::move(segments));
  piece.distance->creases = std::move(creases);
}

Index flip_false_creases(Workpiece& piece) { return Flipper(piece).flip_all(); }

}  // namespace kdm
