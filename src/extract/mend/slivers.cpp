// SPDX-License-Identifier: MIT
// Positions against needles, folds and triangles without area.
#include "extract/mend/slivers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "extract/mend/triangle_shape.h"
#include "extract/place/place.h"
#include "geometry/quadric.h"

namespace kdm {
namespace {

// The shortest side of a needle, as a part of the longest.
constexpr double kNeedle = 0.1;
// A move must make the smallest angle this much wider.
constexpr double kWider = 2;
// Sines above this are all as good.
constexpr double kWide = 0.09;
// How far towards the middle of its hits or its neighbours a vertex may go.
constexpr std::array<double, 2> kParts{0.125, 0.5};

// Of a vertex that is moved. Needles stand round those of large leaves beside many small ones,
// where no move helps.
constexpr std::size_t kMostHits = 32;

class Moving {
 public:
  Moving(const GridView& view, DualMesh& mesh)
      : view_(view), mesh_(mesh), fixed_(mesh.vertices(), 0) {
    for (const auto& [vertex, point] : kept_corners(view.grid, mesh)) fixed_[vertex] = 1;
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
    double gain = kWider;
  };

  // Negative if folded, else the sine of the smallest angle. Three points in a row along a crease
  // are as they should be: a flip is what they need.
  double quality(Index t) const {
    const Vec3& a = mesh_.position[mesh_.vertex[3 * t]];
    const Vec3& b = mesh_.position[mesh_.vertex[3 * t + 1]];
    const Vec3& c = mesh_.position[mesh_.vertex[3 * t + 2]];
    const TriangleShape shape(a, b, c);
    const double sine = shape.least_sine();
    if (sine < kThinSine) {
      return shape.shortest() <= kNeedle * kNeedle * shape.longest() ? sine : kThinSine;
    }
    const double cosine = shape.alignment(view_.grid.plane_of(mesh_.hit[t]).normal);
    return cosine < kFolded ? cosine - kFolded - 1 : std::min(sine, kWide);
  }

  void look_for_move(Index v, Move& best) {
    if (!read_ring(v) || at_corner()) return;
    const Vec3 before = mesh_.position[v];
    const double now = ring_quality(-2);
    const double allowed =
        std::max(distance_to_planes(view_.grid, ring_, before), 0.5 * view_.grid.tolerance);
    for (const double part : kParts) {
      for (const Vec3& goal : {of_hits_, of_neighbours_}) {
        const Vec3 to = before + part * (goal - before);
        if (distance_to_planes(view_.grid, ring_, to) > allowed) continue;
        mesh_.position[v] = to;
        const double gain = gain_of(now, ring_quality(std::max(now, 0.0)));
        if (gain > best.gain) best = {v, to, gain};
      }
    }
    mesh_.position[v] = before;
  }

  // What is folded no more counts for more than any widening.
  static double gain_of(double now, double then) {
    constexpr double kLeast = 1e-5;
    if (then < 0) return 0;
    return now < 0 ? (1 + then) / kLeast : then / std::max(now, kLeast);
  }

  // The hits round the vertex; false if it must stay, on the boundary or at a corner.
  bool read_ring(Index v) {
    if (fixed_[v] != 0 || mesh_.on_boundary(v)) return false;
    ring_.clear();
    Vec3 sum = Vec3::Zero();
    Vec3 around = Vec3::Zero();
    for (const HalfEdgeId h : mesh_.ring(v)) {
      ring_.push_back(mesh_.hit[h / 3]);
      if (ring_.size() > kMostHits) return false;
      sum += view_.hit_points[ring_.back()];
      around += mesh_.position[mesh_.end_vertex(h)];
    }
    of_hits_ = sum / static_cast<double>(ring_.size());
    const LatticeBox& box = view_.boxes[mesh_.leaf[v]];
    of_neighbours_ = (around / static_cast<double>(ring_.size()))
                         .cwiseMax(to_vec3(box.lo))
                         .cwiseMin(to_vec3(box.hi));
    return true;
  }

  // Do the hits' planes meet in one point? Sharp corners stay exact.
  bool at_corner() const {
    PrimalQuadric quadric(of_hits_);
    for (const Index h : ring_) quadric.add(view_.grid.plane_of(h));
    return quadric.certainty().sum() > 2.5;  // the rank
  }

  // The least; once that is below `enough` the rest is not looked at. A triangle still has the
  // number of its hit.
  double ring_quality(double enough) const {
    double least = kWide;
    for (const Index t : ring_) {
      least = std::min(least, quality(t));
      if (least < enough) break;
    }
    return least;
  }

  GridView view_;
  DualMesh& mesh_;
  std::vector<char> fixed_;  // per vertex: the grid keeps a corner for it
  std::vector<Index> ring_;
  Vec3 of_hits_;        // their middle
  Vec3 of_neighbours_;  // theirs, or the leaf's point next to it
};

class AreaGiving {
 public:
  AreaGiving(const GridView& view, DualMesh& mesh)
      : view_(view),
        mesh_(mesh),
        rounding_(0x1p-20 *
                  (view.grid.lattice.origin.cwiseAbs().maxCoeff() / view.grid.lattice.step +
                   kLatticeSize)) {}

  Index run() {
    // What is so far off that 32 bits do not show half the tolerance stays as it is.
    if (view_.grid.tolerance < rounding_ / 4) return 0;
    for (Index t = 0; t < mesh_.triangles(); ++t) {
      if (!mesh_.dropped(t) && without_area(t)) flat_.push_back(t);
    }
    Index moves = 0;
    // Each move leaves fewer; what is in the way of one may be gone later.
    for (bool moved = true; moved;) {
      moved = false;
      for (const Index t : flat_) {
        for (Index h = 3 * t; h < 3 * t + 3 && without_area(t); ++h) {
          if (!move(mesh_.vertex[h])) continue;
          moved = true;
          ++moves;
        }
      }
    }
    return moves;
  }

 private:
  bool without_area(Index t) const {
    const Vec3& a = mesh_.position[mesh_.vertex[3 * t]];
    const Vec3& b = mesh_.position[mesh_.vertex[3 * t + 1]];
    const Vec3& c = mesh_.position[mesh_.vertex[3 * t + 2]];
    const Vec3 first = b - a;
    const Vec3 second = c - a;
    const double longest = std::max(first.cwiseAbs().maxCoeff(), second.cwiseAbs().maxCoeff());
    // Most have far more than rounding can take.
    if (first.cross(second).cwiseAbs().maxCoeff() > rounding_ * longest) return false;
    return is_flat(single_precision(view_.grid.lattice, a), single_precision(view_.grid.lattice, b),
                   single_precision(view_.grid.lattice, c));
  }

  // To where fewer triangles round it are without area.
  bool move(Index v) {
    ring_.clear();
    for (const HalfEdgeId h : mesh_.ring(v)) ring_.push_back(h);
    if (ring_.size() > kMostHits) return false;
    const auto count = [this] {
      return std::count_if(ring_.begin(), ring_.end(),
                           [this](Index h) { return without_area(h / 3); });
    };
    const auto now = count();
    const Vec3 before = mesh_.position[v];
    for (const double part : {1.0 / 64, 1.0 / 16, 1.0 / 4}) {
      for (const Index h : ring_) {
        Vec3 way = part * (mesh_.position[mesh_.end_vertex(h)] - before);
        const double length = way.norm();
        if (length > 0.5 * view_.grid.tolerance) way *= 0.5 * view_.grid.tolerance / length;
        mesh_.position[v] = before + way;
        if (count() < now) return true;
      }
    }
    mesh_.position[v] = before;
    return false;
  }

  GridView view_;
  DualMesh& mesh_;
  double rounding_;  // of a coordinate to 32 bits, generously
  std::vector<Index> flat_;
  std::vector<Index> ring_;
};

}  // namespace

Index move_off_slivers(const GridView& view, DualMesh& mesh) {
  if (!view.grid.rims.empty()) return 0;
  return Moving(view, mesh).run();
}

Index give_area(const GridView& view, DualMesh& mesh) { return AreaGiving(view, mesh).run(); }

}  // namespace kdm
