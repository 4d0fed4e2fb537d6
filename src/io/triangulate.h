// SPDX-License-Identifier: MIT
// Cuts polygons in space into triangles, by ear clipping.
#pragma once

#include <cstddef>
#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

/// Cuts polygons, convex or not. A polygon is seen along the axis that is nearest to its Newell
/// normal. It may repeat corners, have several on one line, and have holes if these are joined to
/// its outline by a bridge that is passed twice. Usual polygons take time about linear in their
/// corners. The effort is limited to a multiple of the corners; if that is not enough, the rest of
/// the polygon is cut without regard for its outline. Working arrays are kept between calls.
class Triangulator {
 public:
  /// Cuts the polygon whose `count` corners (3 at least) have the positions
  /// `positions[corners[i]]`. Writes count - 2 triangles over these corners to `out`, oriented like
  /// the polygon. The polygon's edges are among the triangles' edges, so neighbours stay joined. A
  /// polygon without area, or one that cuts itself, is cut into count - 2 triangles too, but some
  /// of them have no area or overlap. A polygon that is no convex quadrilateral is cut in the same
  /// way wherever its outline starts, and whichever way it runs: a face's back is cut like its
  /// front.
  void cut(const std::vector<Vec3>& positions, const Index* corners, std::size_t count,
           Triangle* out);

 private:
  struct Point {
    double u, v;
    friend bool operator==(const Point& a, const Point& b) { return a.u == b.u && a.v == b.v; }
  };

  bool put_in_order(const std::vector<Vec3>& positions, const Index* corners, std::size_t count);
  void cut_ordered(Triangle* out);
  void project(const std::vector<Vec3>& positions, const Index* corners, std::size_t count);
  double cross(Index a, Index b, Index c) const;
  bool is_ear(Index tip, bool touching_allowed);
  bool blocks(Index other, Index a, Index b, Index c, bool touching_allowed) const;
  bool enters(Index other, Index corner, Index from, Index to) const;
  bool is_spike(Index tip) const;
  void clip(Index tip);
  bool clip_spikes(Index first, std::size_t enough);
  void fill_buckets();
  std::size_t column(double u) const;
  std::size_t row(double v) const;

  std::vector<Index> ordered_;  // the corners, in the order in which they are looked at
  Triangle* out_ = nullptr;
  std::vector<Point> points_;
  std::vector<Index> next_, previous_;  // the ring of corners that are left; kNone: removed
  std::size_t left_ = 0;
  std::size_t effort_ = 0;  // how many corners and buckets were looked at
  // Corners that are not convex, the only ones that can be in the way of an ear, are kept in
  // buckets: side_ rows of side_ buckets cover the polygon. Bucket i holds the corners from place
  // bucket_start_[i] to before bucket_start_[i + 1] of bucket_corners_.
  std::vector<Index> bucket_start_, bucket_corners_;
  std::size_t side_ = 1;
  std::size_t left_when_filled_ = 0;
  Point low_{0, 0};
  double u_scale_ = 0, v_scale_ = 0;  // buckets per unit
};

}  // namespace kdm
