// SPDX-License-Identifier: MIT
// Edge flips against folds.
#include "extract/unfold.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

namespace kdm {
namespace {

// A triangle further than about 78 degrees off its plane is folded.
constexpr double kFolded = 0.2;
// A flip must be worth it.
constexpr double kGain = 0.1;
// Triangles this thin have no direction: height over length.
constexpr double kFlat = 1e-6;
constexpr int kMaxFlips = 4;  // of one triangle

class Unfolding {
 public:
  Unfolding(const GridData& grid, const Details& details, DualMesh& mesh)
      : grid_(grid), mesh_(mesh), flips_(mesh.triangles(), 0) {
    if (details.hits.empty()) return;
    for (Index t = 0; t < mesh.triangles(); ++t) {
      if (details.of_hit(mesh.hit[t]) != Detail::kPlain) flips_[t] = kMaxFlips;
    }
  }

  Index run(const std::vector<Index>* triangles) {
    if (triangles != nullptr) {
      for (const Index t : *triangles) look_at(t);
    } else {
      for (Index t = 0; t < mesh_.triangles(); ++t) look_at(t);
    }
    Index flips = 0;
    while (!queue_.empty()) {
      const Index t = queue_.back();
      queue_.pop_back();
      if (folded(t) && flip_best(t)) ++flips;
    }
    return flips;
  }

 private:
  void look_at(Index t) {
    if (!mesh_.dropped(t) && folded(t)) queue_.push_back(t);
  }

  bool folded(Index t) const {
    const Index* v = &mesh_.vertex[3 * t];
    return alignment(v[0], v[1], v[2], mesh_.hit[t]) < kFolded;
  }

  // Cosine between the triangle's normal and that of the hit's plane; -1 without area.
  double alignment(Index a, Index b, Index c, Index hit) const {
    const Vec3& p = mesh_.position[a];
    const Vec3 first = mesh_.position[b] - p;
    const Vec3 second = mesh_.position[c] - p;
    const Vec3 normal = first.cross(second);
    const double length = normal.norm();
    const double longest =
        std::max({first.squaredNorm(), second.squaredNorm(), (second - first).squaredNorm()});
    if (!(length > kFlat * longest)) return -1;
    return normal.dot(grid_.plane_of(hit).normal) / length;
  }

  struct Flip {
    Index half_edge = kNone;
    double quality = 0;
    bool swap_hits = false;
  };

  // Flips the edge of t that leaves the better pair of triangles; false if none does.
  bool flip_best(Index t) {
    Flip best;
    for (Index h = 3 * t; h < 3 * t + 3; ++h) {
      const Flip flip = judge(h);
      if (flip.half_edge != kNone && (best.half_edge == kNone || flip.quality > best.quality)) {
        best = flip;
      }
    }
    if (best.half_edge == kNone) return false;
    const Index other = mesh_.opposite[best.half_edge] / 3;
    mesh_.mark_edited(mesh_.hit[t]);
    mesh_.mark_edited(mesh_.hit[other]);
    if (best.swap_hits) std::swap(mesh_.hit[t], mesh_.hit[other]);
    flip(best.half_edge);
    ++flips_[t];
    ++flips_[other];
    if (folded(t)) queue_.push_back(t);
    if (folded(other)) queue_.push_back(other);
    return true;
  }

  // What the flip of the edge a-b between (a, b, c) and (b, a, d) to c-d would give.
  Flip judge(Index ab) const {
    const Index ba = mesh_.opposite[ab];
    if (ba == kNone) return {};
    if (flips_[ab / 3] >= kMaxFlips || flips_[ba / 3] >= kMaxFlips) return {};
    const Index a = mesh_.vertex[ab];
    const Index b = mesh_.vertex[ba];
    const Index c = mesh_.vertex[previous_in_triangle(ab)];
    const Index d = mesh_.vertex[previous_in_triangle(ba)];
    if (c == d || shorter_than_four(a) || shorter_than_four(b) || joined(c, d)) return {};
    const Index hit = mesh_.hit[ab / 3];
    const Index other = mesh_.hit[ba / 3];
    const double now = std::min(alignment(a, b, c, hit), alignment(b, a, d, other));
    const double allowed = std::max({grid_.tolerance, off_plane(c, hit), off_plane(d, other)});
    Flip best;
    for (const bool swap : {false, true}) {
      const Index first = swap ? other : hit;
      const Index second = swap ? hit : other;
      const double then = std::min(alignment(a, d, c, first), alignment(d, b, c, second));
      if (then < now + kGain || (best.half_edge != kNone && then <= best.quality)) continue;
      // A crease must not be cut off.
      const double off =
          std::max({off_plane(a, first), off_plane(d, first), off_plane(c, first),
                    off_plane(d, second), off_plane(b, second), off_plane(c, second)});
      if (off <= allowed) best = {ab, then, swap};
    }
    return best;
  }

  double off_plane(Index v, Index hit) const {
    return grid_.plane_of(hit).distance(mesh_.position[v]);
  }

  // A vertex loses an edge by a flip and must keep three, or two on the boundary.
  bool shorter_than_four(Index v) const {
    if (mesh_.boundary_into(v) != kNone) return false;
    const Index first = mesh_.first[v];
    Index half_edge = first;
    int count = 0;
    do {
      if (++count == 4) return false;
      half_edge = next_in_triangle(mesh_.opposite[half_edge]);
    } while (half_edge != first);
    return true;
  }

  bool joined(Index v, Index w) const {
    const Index first = mesh_.first[v];
    Index half_edge = first;
    do {
      if (mesh_.vertex[next_in_triangle(half_edge)] == w) return true;
      half_edge = mesh_.turn(half_edge);
    } while (half_edge != first && half_edge != kNone);
    return half_edge == kNone && mesh_.vertex[mesh_.boundary_into(v)] == w;
  }

  // (a, b, c) and (b, a, d) become (a, d, c) and (d, b, c).
  void flip(Index ab) {
    const Index ba = mesh_.opposite[ab];
    const Index bc = next_in_triangle(ab);
    const Index ca = previous_in_triangle(ab);
    const Index ad = next_in_triangle(ba);
    const Index db = previous_in_triangle(ba);
    const Index b = mesh_.vertex[ba];
    const Index c = mesh_.vertex[ca];
    const Index d = mesh_.vertex[db];
    const Index beyond_ad = mesh_.opposite[ad];
    const Index beyond_db = mesh_.opposite[db];
    const Index beyond_bc = mesh_.opposite[bc];
    mesh_.link(ab, beyond_ad);  // a-d
    mesh_.link(ba, beyond_db);  // d-b
    mesh_.link(ad, beyond_bc);  // b-c
    mesh_.link(bc, db);         // d-c and c-d
    mesh_.vertex[ba] = d;
    mesh_.vertex[ad] = b;
    mesh_.vertex[bc] = d;
    mesh_.vertex[db] = c;
    mesh_.set_first(mesh_.vertex[ab], ab);
    mesh_.set_first(b, ad);
    mesh_.set_first(c, ca);
    mesh_.set_first(d, ba);
    mesh_.strip[ab / 3] = mesh_.strip[ba / 3] = 0;
  }

  const GridData& grid_;
  DualMesh& mesh_;
  std::vector<Index> queue_;
  std::vector<int> flips_;  // per triangle
};

}  // namespace

Index unfold(const GridData& grid, const Details& details, DualMesh& mesh,
             const std::vector<Index>* triangles) {
  return Unfolding(grid, details, mesh).run(triangles);
}

}  // namespace kdm
