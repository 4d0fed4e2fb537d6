// SPDX-License-Identifier: MIT
// Cuts a polygon in space into triangles by ear clipping, concave ones properly.
#pragma once

#include <cstddef>
#include <vector>

#include "kdmanifold/types.h"

namespace kdm {

/// Keeps its working arrays between calls. The polygon is seen along the axis its Newell normal
/// is nearest to; polygons with holes cut open by a bridge, repeated and collinear corners are
/// welcome. About linear in the corners for usual polygons; the effort is bounded by a multiple of
/// the corners, and what is left then is cut anyhow.
class Triangulator {
 public:
  /// Writes count - 2 triangles over the polygon's own corners, oriented like the polygon; its
  /// edges are among theirs, so neighbours stay joined. A polygon without area or one that cuts
  /// itself gets as many (then some of them are degenerate or overlap). `count` >= 3.
  void cut(const std::vector<Vec3>& positions, const Index* corners, std::size_t count,
           Triangle* out);

 private:
  struct Point {
    double u, v;
    friend bool operator==(const Point& a, const Point& b) { return a.u == b.u && a.v == b.v; }
  };

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

  const Index* corners_ = nullptr;
  Triangle* out_ = nullptr;
  std::vector<Point> points_;
  std::vector<Index> next_, previous_;  // the ring of corners that are left; kNone: removed
  std::size_t left_ = 0;
  std::size_t effort_ = 0;  // corners and buckets looked at
  // Corners that are not convex, the only ones that can be in the way of an ear, in a square of
  // side_ * side_ buckets over the polygon: bucket i is [bucket_start_[i], bucket_start_[i + 1]).
  std::vector<Index> bucket_start_, bucket_corners_;
  std::size_t side_ = 1;
  std::size_t left_when_filled_ = 0;
  Point low_{0, 0};
  double u_scale_ = 0, v_scale_ = 0;  // buckets per unit
};

}  // namespace kdm
