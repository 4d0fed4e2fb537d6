// SPDX-License-Identifier: MIT
// Flips edges where that removes folds or widens thin triangles.
#include "extract/mend/unfold.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "extract/mend/triangle_shape.h"

namespace kdm {
namespace {

// Of the two triangles at an edge, the worse is the one with the smaller cosine between its normal
// and its hit's normal. A flip of a folded triangle must raise this cosine by at least so much.
constexpr double kMinAlignmentGain = 0.1;
// A flip of a thin triangle must make the smallest angle of the two triangles this many times as
// wide.
constexpr double kMinWidening = 2;
// After a flip of a thin triangle the cosine between each of the two and its plane is above this,
// or above the better one of before.
constexpr double kMinAlignment = 0.9;
// No triangle takes part in more flips than this, so that the flips end.
constexpr int kMaxFlips = 4;

class Unfolding {
 public:
  Unfolding(const GridView& view, const EmbedLevels& levels, DualMesh& mesh, EditLog& log)
      : view_(view), mesh_(mesh), log_(log), flips_(mesh.triangles(), 0) {
    if (levels.hits.empty()) return;
    for (Index t = 0; t < mesh.triangles(); ++t) {
      if (levels.of_hit(mesh.hit[t]) != EmbedLevel::kTriangle) flips_[t] = kMaxFlips;
    }
  }

  Index run(const Scope& triangles) {
    triangles.for_each(mesh_.triangles(), [&](TriangleId t) { look_at(t); });
    Index flips = 0;
    while (!queue_.empty()) {
      const Index t = queue_.back();
      queue_.pop_back();
      const TriangleShape shape = shape_of(t);
      if ((folded(t, shape) && flip_best(t, &Unfolding::flatter)) ||
          (thin(shape) && flip_best(t, &Unfolding::wider))) {
        ++flips;
      }
    }
    log_.note_flips(flips);
    return flips;
  }

 private:
  void look_at(Index t) {
    if (mesh_.dropped(t)) return;
    const TriangleShape shape = shape_of(t);
    if (folded(t, shape) || thin(shape)) queue_.push_back(t);
  }

  bool folded(Index t, const TriangleShape& shape) const {
    return shape.alignment(view_.grid.plane_of(mesh_.hit[t]).normal) < kFolded;
  }

  static bool thin(const TriangleShape& shape) { return shape.least_sine() < kThinSine; }

  TriangleShape shape_of(Index t) const {
    const Index* v = &mesh_.vertex[3 * t];
    return shape_of(v[0], v[1], v[2]);
  }

  TriangleShape shape_of(Index a, Index b, Index c) const {
    return {mesh_.position[a], mesh_.position[b], mesh_.position[c]};
  }

  double alignment(Index a, Index b, Index c, Index hit) const {
    return shape_of(a, b, c).alignment(view_.grid.plane_of(hit).normal);
  }

  double least_sine(Index a, Index b, Index c) const { return shape_of(a, b, c).least_sine(); }

  struct Flip {
    Index half_edge = kNone;
    double quality = 0;
    std::array<Index, 2> hits{};  // the hits that the two triangles stand for after the flip
  };
  // Two triangles with a common edge a-b: (a, b, c) and (b, a, d), and the hits that they stand
  // for.
  struct Pair {
    Index a, b, c, d, hit, other;
  };

  // Flips the edge of t that leaves the best pair of triangles; returns false if no flip is worth
  // it.
  bool flip_best(Index t, Flip (Unfolding::*judge)(Index, const Pair&) const) {
    Flip best;
    for (Index h = 3 * t; h < 3 * t + 3; ++h) {
      const std::optional<Pair> pair = flippable(h);
      if (!pair) continue;
      const Flip flip = (this->*judge)(h, *pair);
      if (flip.half_edge != kNone && (best.half_edge == kNone || flip.quality > best.quality)) {
        best = flip;
      }
    }
    if (best.half_edge == kNone) return false;
    const Index other = mesh_.opposite[best.half_edge] / 3;
    log_.note_edited(mesh_.hit[t]);
    log_.note_edited(mesh_.hit[other]);
    mesh_.hit[t] = best.hits[0];
    mesh_.hit[other] = best.hits[1];
    flip(best.half_edge);
    ++flips_[t];
    ++flips_[other];
    look_at(t);
    look_at(other);
    return true;
  }

  std::optional<Pair> flippable(Index ab) const {
    const Index ba = mesh_.opposite[ab];
    if (ba == kNone || flips_[ab / 3] >= kMaxFlips || flips_[ba / 3] >= kMaxFlips) return {};
    const Pair pair{mesh_.vertex[ab],
                    mesh_.vertex[ba],
                    mesh_.vertex[previous_in_triangle(ab)],
                    mesh_.vertex[previous_in_triangle(ba)],
                    mesh_.hit[ab / 3],
                    mesh_.hit[ba / 3]};
    for (const Index v : {pair.a, pair.b, pair.c, pair.d}) {
      if (mesh_.keeps_edges(v)) return {};
    }
    if (pair.c == pair.d || shorter_than_four(pair.a) || shorter_than_four(pair.b) ||
        joined(pair.c, pair.d)) {
      return {};
    }
    return pair;
  }

  // Returns the flip of a-b to c-d if it turns the two triangles nearer to their planes.
  Flip flatter(Index ab, const Pair& pair) const {
    const auto& [a, b, c, d, hit, other] = pair;
    const double now = std::min(alignment(a, b, c, hit), alignment(b, a, d, other));
    Flip best;
    for (const auto& hits : {std::array{hit, other}, std::array{other, hit}}) {
      const double then = std::min(alignment(a, d, c, hits[0]), alignment(d, b, c, hits[1]));
      if (then < now + kMinAlignmentGain || (best.half_edge != kNone && then <= best.quality))
        continue;
      if (keeps_creases(pair, hits)) best = {ab, then, hits};
    }
    return best;
  }

  // Returns the flip of a-b to c-d if it widens the smallest angle of the two triangles. Both
  // triangles may come to stand for the same hit if the area that the thin one covered lies in the
  // hit's plane.
  Flip wider(Index ab, const Pair& pair) const {
    const auto& [a, b, c, d, hit, other] = pair;
    const double now = std::min(least_sine(a, b, c), least_sine(b, a, d));
    const double then = std::min(least_sine(a, d, c), least_sine(d, b, c));
    if (!(then > kMinWidening * now)) return {};
    double aligned =
        std::min(kMinAlignment, std::max(alignment(a, b, c, hit), alignment(b, a, d, other)));
    Flip best;
    for (const auto& hits : {std::array{hit, other}, std::array{other, hit}, std::array{hit, hit},
                             std::array{other, other}}) {
      const double nearest = std::min(alignment(a, d, c, hits[0]), alignment(d, b, c, hits[1]));
      if (!(nearest > aligned) || !keeps_creases(pair, hits)) continue;
      best = {ab, then, hits};
      aligned = nearest;
    }
    return best;
  }

  // Tells whether the triangles (a, d, c) and (d, b, c) of these hits cut no crease off: whether
  // their corners lie within the tolerance of the hits' planes, or as near as c and d did.
  bool keeps_creases(const Pair& pair, const std::array<Index, 2>& hits) const {
    const auto& [a, b, c, d, hit, other] = pair;
    const double allowed = std::max({view_.grid.tolerance, off_plane(c, hit), off_plane(d, other)});
    return std::max({off_plane(a, hits[0]), off_plane(d, hits[0]), off_plane(c, hits[0]),
                     off_plane(d, hits[1]), off_plane(b, hits[1]), off_plane(c, hits[1])}) <=
           allowed;
  }

  double off_plane(Index v, Index hit) const {
    return view_.grid.plane_of(hit).distance(mesh_.position[v]);
  }

  // Tells whether the vertex has too few edges to lose one by a flip: it must keep three, or two on
  // the boundary.
  bool shorter_than_four(Index v) const {
    if (mesh_.on_boundary(v)) return false;
    int edges = 0;
    for ([[maybe_unused]] const HalfEdgeId h : mesh_.ring(v)) {
      if (++edges == 4) return false;
    }
    return true;
  }

  bool joined(Index v, Index w) const {
    for (const HalfEdgeId h : mesh_.ring(v)) {
      if (mesh_.end_vertex(h) == w) return true;
    }
    return mesh_.on_boundary(v) && mesh_.vertex[mesh_.boundary_into(v)] == w;
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
    mesh_.set_first_half_edge(mesh_.vertex[ab], ab);
    mesh_.set_first_half_edge(b, ad);
    mesh_.set_first_half_edge(c, ca);
    mesh_.set_first_half_edge(d, ba);
    mesh_.strip[ab / 3] = mesh_.strip[ba / 3] = 0;
  }

  GridView view_;
  DualMesh& mesh_;
  EditLog& log_;
  std::vector<Index> queue_;
  std::vector<int> flips_;  // per triangle
};

}  // namespace

Index unfold(const GridView& view, const EmbedLevels& levels, DualMesh& mesh, EditLog& log,
             const Scope& triangles) {
  return Unfolding(view, levels, mesh, log).run(triangles);
}

}  // namespace kdm
