// SPDX-License-Identifier: MIT
// Moves vertices of triangles whose corners lie on one line once they are rounded to 32 bits.
#include "extract/mend/give_area.h"

#include <algorithm>
#include <vector>

#include "extract/mend/triangle_shape.h"

namespace kdm {
namespace {

// A vertex with more triangles than this is not moved.
constexpr std::size_t kMaxTriangles = 32;

class AreaGiving {
 public:
  AreaGiving(const GridView& view, DualMesh& mesh)
      : view_(view),
        mesh_(mesh),
        rounding_(0x1p-20 *
                  (view.grid.lattice.origin.cwiseAbs().maxCoeff() / view.grid.lattice.step +
                   kLatticeSize)) {}

  Index run() {
    // Far from the origin 32 bits do not show half the tolerance, and no move would help.
    if (view_.grid.tolerance < rounding_ / 4) return 0;
    for (Index t = 0; t < mesh_.triangles(); ++t) {
      if (!mesh_.dropped(t) && without_area(t)) flat_.push_back(t);
    }
    Index moves = 0;
    // Ends, since each move leaves fewer without area. A move that is in the way of another one may
    // be gone in the next round.
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
    // Most triangles have far more area than rounding can take away: the exact test is for the
    // rest.
    if (first.cross(second).cwiseAbs().maxCoeff() > rounding_ * longest) return false;
    return is_flat(single_precision(view_.grid.lattice, a), single_precision(view_.grid.lattice, b),
                   single_precision(view_.grid.lattice, c));
  }

  // Moves the vertex along one of its edges to where fewer triangles round it are without area.
  // Returns false, and leaves it where it is, if no move helps.
  bool move(Index v) {
    ring_.clear();
    for (const HalfEdgeId h : mesh_.ring(v)) ring_.push_back(h);
    if (ring_.size() > kMaxTriangles) return false;
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
  double rounding_;  // more than rounding a coordinate to 32 bits changes it, lattice units
  std::vector<TriangleId> flat_;  // without area
  std::vector<Index> ring_;
};

}  // namespace

Index give_area(const GridView& view, DualMesh& mesh) { return AreaGiving(view, mesh).run(); }

}  // namespace kdm
