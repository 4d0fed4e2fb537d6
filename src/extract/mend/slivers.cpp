// SPDX-License-Identifier: MIT
// Moves vertices within their leaves, one triangle at a time.
#include "extract/mend/slivers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "extract/mend/triangle_shape.h"
#include "extract/place/place.h"
#include "extract/place/vertex_position.h"
#include "geometry/quadric.h"
#include "mesh/marks.h"

namespace kdm {
namespace {

// A thin triangle is a needle if its shortest side is at most this fraction of its longest.
constexpr double kNeedleSides = 0.1;
// A move must make the smallest angle this many times as wide.
constexpr double kMinGain = 2;
// All angles with a larger sine than this (5 degrees) count alike.
constexpr double kWideSine = 0.09;
// A vertex is tried at these fractions of the way to the middle of its hits or of its neighbours.
constexpr std::array<double, 2> kSteps{0.125, 0.5};
// A vertex with more hits than this is not moved: it belongs to a large leaf beside many small ones
// and has needles round it that no move takes away.
constexpr std::size_t kMaxHits = 32;

class Moving {
 public:
  Moving(const GridView& view, DualMesh& mesh) : view_(view), mesh_(mesh), fixed_(mesh.vertices()) {
    for (const auto& [vertex, point] : kept_corners(view.grid, mesh)) fixed_.set(vertex);
  }

  Index run() {
    Index moves = 0;
    for (Index t = 0; t < mesh_.triangles(); ++t) {
      if (mesh_.dropped(t) || quality(t) >= kThinSine) continue;
      Move best;
      for (Index h = 3 * t; h < 3 * t + 3; ++h) look_for_move(mesh_.vertex[h], best);
      if (best.vertex == kNone) continue;
      mesh_.position[best.vertex] = best.to;
      ++moves;
    }
    return moves;
  }

 private:
  struct Move {
    Index vertex = kNone;
    Vec3 to = Vec3::Zero();
    double gain = kMinGain;
  };

  // Returns a negative number for a folded triangle, else the sine of its smallest angle. A thin
  // triangle that is no needle, three vertices in a row along a crease, counts as not thin: no move
  // makes it better, a flip does.
  double quality(Index t) const {
    const Vec3& a = mesh_.position[mesh_.vertex[3 * t]];
    const Vec3& b = mesh_.position[mesh_.vertex[3 * t + 1]];
    const Vec3& c = mesh_.position[mesh_.vertex[3 * t + 2]];
    const TriangleShape shape(a, b, c);
    const double sine = shape.least_sine();
    if (sine < kThinSine) {
      return shape.shortest() <= kNeedleSides * kNeedleSides * shape.longest() ? sine : kThinSine;
    }
    const double cosine = shape.alignment(view_.grid.plane_of(mesh_.hit[t]).normal);
    return cosine < kFolded ? cosine - kFolded - 1 : std::min(sine, kWideSine);
  }

  void look_for_move(Index v, Move& best) {
    if (!read_ring(v) || at_corner()) return;
    const Vec3 before = mesh_.position[v];
    const double now = ring_quality(-2);
    const double allowed =
        std::max(distance_to_planes(view_.grid, ring_, before), 0.5 * view_.grid.tolerance);
    for (const double part : kSteps) {
      for (const Vec3& goal : {middle_of_hits_, middle_of_neighbours_}) {
        const Vec3 to = before + part * (goal - before);
        if (distance_to_planes(view_.grid, ring_, to) > allowed) continue;
        mesh_.position[v] = to;
        const double gain = gain_of(now, ring_quality(std::max(now, 0.0)));
        if (gain > best.gain) best = {v, to, gain};
      }
    }
    mesh_.position[v] = before;
  }

  // Returns how much better the ring becomes: unfolding a triangle counts for more than widening
  // any angle.
  static double gain_of(double now, double then) {
    constexpr double kLeast = 1e-5;
    if (then < 0) return 0;
    return now < 0 ? (1 + then) / kLeast : then / std::max(now, kLeast);
  }

  // Reads the hits round the vertex and the two goals of its moves. Returns false if the vertex
  // must stay: on the boundary, at a corner that the grid keeps, or with too many hits.
  bool read_ring(Index v) {
    if (fixed_.test(v) || mesh_.on_boundary(v)) return false;
    ring_.clear();
    Vec3 sum = Vec3::Zero();
    Vec3 around = Vec3::Zero();
    for (const HalfEdgeId h : mesh_.ring(v)) {
      ring_.push_back(mesh_.hit[h / 3]);
      if (ring_.size() > kMaxHits) return false;
      sum += view_.hit_points[ring_.back()];
      around += mesh_.position[mesh_.end_vertex(h)];
    }
    middle_of_hits_ = sum / static_cast<double>(ring_.size());
    const LatticeBox& box = view_.boxes[mesh_.leaf[v]];
    middle_of_neighbours_ = (around / static_cast<double>(ring_.size()))
                                .cwiseMax(to_vec3(box.lo))
                                .cwiseMin(to_vec3(box.hi));
    return true;
  }

  // Tells whether the hits' planes meet in one point: vertices at such corners must not move.
  bool at_corner() const {
    PrimalQuadric quadric(middle_of_hits_);
    for (const Index h : ring_) quadric.add(view_.grid.plane_of(h));
    return quadric.certainty().sum() > 2.5;  // the rank
  }

  // Returns the least quality of the triangles round the vertex, or of the first ones if it is
  // below `enough`. Every triangle has the number of its hit here.
  double ring_quality(double enough) const {
    double least = kWideSine;
    for (const Index t : ring_) {
      least = std::min(least, quality(t));
      if (least < enough) break;
    }
    return least;
  }

  GridView view_;
  DualMesh& mesh_;
  Marks fixed_;  // per vertex: the grid keeps a corner for it
  // Of the vertex at hand:
  std::vector<HitId> ring_;
  Vec3 middle_of_hits_;
  Vec3 middle_of_neighbours_;  // moved into the leaf
};

}  // namespace

Index move_off_slivers(const GridView& view, DualMesh& mesh) {
  if (!view.grid.rims.empty()) return 0;
  return Moving(view, mesh).run();
}

}  // namespace kdm
