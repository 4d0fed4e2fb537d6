// SPDX-License-Identifier: MIT
// Ear clipping after G. Meisters, "Polygons have ears" (1975), extended to collinear and coincident
// corners: a corner that touches an ear counts as inside it, unless it coincides with one of the
// ear's corners and its own edges stay outside.
#include "io/triangulate.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace kdm {
namespace {

// Limits the corners and buckets that are looked at, for each corner of a polygon. Without a limit,
// outlines that cut themselves everywhere would take time cubic in their corners. Measured per
// corner: a circle 15, a comb of 20,000 teeth 3,100, a spiral of 40,000 corners 8,400.
constexpr std::size_t kMostEffortPerCorner = 20000;

}  // namespace

void Triangulator::project(const std::vector<Vec3>& positions, const Index* corners,
                           std::size_t count) {
  const Vec3& origin = positions[corners[0]];
  Vec3 normal = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const Vec3 a = positions[corners[i]] - origin;
    const Vec3 b = positions[corners[i + 1]] - origin;
    normal += a.cross(b);
  }
  int axis = 0;
  for (int other = 1; other < 3; ++other) {
    if (std::abs(normal[other]) > std::abs(normal[axis])) axis = other;
  }
  int u = (axis + 1) % 3;
  int v = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(u, v);  // counter-clockwise from here on
  points_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3& p = positions[corners[i]];
    points_[i] = {p[u], p[v]};
  }
}

// Returns twice the signed area of (a, b, c): positive if they turn left.
double Triangulator::cross(Index a, Index b, Index c) const {
  const Point& p = points_[a];
  const Point& q = points_[b];
  const Point& r = points_[c];
  return (q.u - p.u) * (r.v - p.v) - (q.v - p.v) * (r.u - p.u);
}

// Tells whether one of the edges of `other`, which coincides with `corner`, runs into the angle
// between the directions from `corner` to `from` and to `to` (counter-clockwise, less than half a
// turn).
bool Triangulator::enters(Index other, Index corner, Index from, Index to) const {
  for (Index end : {previous_[other], next_[other]}) {
    if (cross(corner, from, end) > 0 && cross(corner, end, to) > 0) return true;
  }
  return false;
}

// Tells whether the corner `other` is in the way of the ear (a, b, c).
bool Triangulator::blocks(Index other, Index a, Index b, Index c, bool touching_allowed) const {
  const double ab = cross(a, b, other);
  const double bc = cross(b, c, other);
  const double ca = cross(c, a, other);
  if (ab < 0 || bc < 0 || ca < 0) return false;
  if (ab > 0 && bc > 0 && ca > 0) return true;
  if (touching_allowed) return false;
  const Point& p = points_[other];
  if (p == points_[a]) return enters(other, a, b, c);
  if (p == points_[b]) return enters(other, b, c, a);
  if (p == points_[c]) return enters(other, c, a, b);
  // On an edge of the ear a convex corner would overlap the polygon there: only flat or reflex
  // ones count.
  return cross(previous_[other], other, next_[other]) <= 0;
}

std::size_t Triangulator::column(double u) const {
  return std::min(side_ - 1, static_cast<std::size_t>((u - low_.u) * u_scale_));
}

std::size_t Triangulator::row(double v) const {
  return std::min(side_ - 1, static_cast<std::size_t>((v - low_.v) * v_scale_));
}

// Puts the corners that are not convex into buckets. Corners that are convex now need not be looked
// at again: clipping clean ears makes no corner less convex.
void Triangulator::fill_buckets() {
  left_when_filled_ = left_;
  effort_ += next_.size();
  std::size_t count = 0;
  const auto in_the_way = [this](Index i) {
    return next_[i] != kNone && !(cross(previous_[i], i, next_[i]) > 0);
  };
  for (Index i = 0; i < next_.size(); ++i) count += in_the_way(i);
  side_ = 1;
  while (side_ * side_ * 2 < count) ++side_;
  Point high = low_ = points_[0];
  for (const Point& p : points_) {
    low_ = {std::min(low_.u, p.u), std::min(low_.v, p.v)};
    high = {std::max(high.u, p.u), std::max(high.v, p.v)};
  }
  // A polygon too flat or too large to divide goes into one column or row.
  const auto scale = [this](double extent) {
    const double buckets = static_cast<double>(side_) / extent;
    return extent > 0 && std::isfinite(buckets) ? buckets : 0;
  };
  u_scale_ = scale(high.u - low_.u);
  v_scale_ = scale(high.v - low_.v);
  bucket_start_.assign(side_ * side_ + 1, 0);
  bucket_corners_.resize(count);
  const auto bucket = [this](Index i) { return row(points_[i].v) * side_ + column(points_[i].u); };
  for (Index i = 0; i < next_.size(); ++i) {
    if (in_the_way(i)) ++bucket_start_[bucket(i)];
  }
  std::partial_sum(bucket_start_.begin(), bucket_start_.end(), bucket_start_.begin());
  for (auto i = static_cast<Index>(next_.size()); i-- > 0;) {
    if (in_the_way(i)) bucket_corners_[--bucket_start_[bucket(i)]] = i;
  }
}

bool Triangulator::is_ear(Index tip, bool touching_allowed) {
  const Index a = previous_[tip];
  const Index c = next_[tip];
  ++effort_;
  if (!(cross(a, tip, c) > 0)) return false;
  const auto [u_min, u_max] = std::minmax({points_[a].u, points_[tip].u, points_[c].u});
  const auto [v_min, v_max] = std::minmax({points_[a].v, points_[tip].v, points_[c].v});
  const std::size_t first = column(u_min), last = column(u_max);
  for (std::size_t r = row(v_min), end = row(v_max); r <= end; ++r) {
    const Index* it = bucket_corners_.data() + bucket_start_[r * side_ + first];
    const Index* const stop = bucket_corners_.data() + bucket_start_[r * side_ + last + 1];
    effort_ += 1 + static_cast<std::size_t>(stop - it);
    for (; it != stop; ++it) {
      const Point& p = points_[*it];
      if (p.u < u_min || p.u > u_max || p.v < v_min || p.v > v_max) continue;
      if (next_[*it] == kNone || *it == a || *it == tip || *it == c) continue;
      if (blocks(*it, a, tip, c, touching_allowed)) return false;
    }
  }
  return true;
}

// Tells whether the outline goes back at the tip the way it came, or does not move there at all.
bool Triangulator::is_spike(Index tip) const {
  const Point& a = points_[previous_[tip]];
  const Point& b = points_[tip];
  const Point& c = points_[next_[tip]];
  return cross(previous_[tip], tip, next_[tip]) == 0 &&
         (a.u - b.u) * (c.u - b.u) + (a.v - b.v) * (c.v - b.v) >= 0;
}

void Triangulator::clip(Index tip) {
  *out_++ = {ordered_[previous_[tip]], ordered_[tip], ordered_[next_[tip]]};
  next_[previous_[tip]] = next_[tip];
  previous_[next_[tip]] = previous_[tip];
  next_[tip] = kNone;
  --left_;
}

// Clips spikes from `first` on, until `enough` corners in a row are none. Tells whether one was
// found.
bool Triangulator::clip_spikes(Index first, std::size_t enough) {
  bool found = false;
  Index tip = first;
  for (std::size_t in_a_row = 0; in_a_row < enough && left_ > 3;) {
    if (is_spike(tip)) {
      const Index before = previous_[tip];  // may have become a spike
      clip(tip);
      tip = before;
      in_a_row = 0;
      found = true;
    } else {
      tip = next_[tip];
      ++in_a_row;
    }
  }
  return found;
}

void Triangulator::cut(const std::vector<Vec3>& positions, const Index* corners, std::size_t count,
                       Triangle* out) {
  if (count == 3) {
    out[0] = {corners[0], corners[1], corners[2]};
    return;
  }
  if (count == 4) {
    project(positions, corners, count);
    if (cross(0, 1, 2) > 0 && cross(1, 2, 3) > 0 && cross(2, 3, 0) > 0 && cross(3, 0, 1) > 0) {
      out[0] = {corners[0], corners[1], corners[2]};  // convex, the usual case
      out[1] = {corners[0], corners[2], corners[3]};
      return;
    }
  }
  const bool turned = put_in_order(positions, corners, count);
  project(positions, ordered_.data(), count);
  cut_ordered(out);
  if (!turned) return;
  for (std::size_t i = 0; i + 2 < count; ++i) std::swap(out[i][1], out[i][2]);
}

// Lets the outline begin at the corner with the lowest coordinates, and run from there towards the
// lower one of its neighbours. Returns whether it ran the other way.
bool Triangulator::put_in_order(const std::vector<Vec3>& positions, const Index* corners,
                                std::size_t count) {
  const auto below = [&](std::size_t a, std::size_t b) {
    const Vec3& p = positions[corners[a]];
    const Vec3& q = positions[corners[b]];
    return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
  };
  std::size_t first = 0;
  for (std::size_t i = 1; i < count; ++i) {
    if (below(i, first)) first = i;
  }
  const bool turned = below((first + count - 1) % count, (first + 1) % count);
  ordered_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    ordered_[i] = corners[(first + (turned ? count - i : i)) % count];
  }
  return turned;
}

void Triangulator::cut_ordered(Triangle* out) {
  const std::size_t count = ordered_.size();
  out_ = out;
  left_ = count;
  next_.resize(count);
  previous_.resize(count);
  for (Index i = 0; i < count; ++i) {
    next_[i] = i + 1 == count ? 0 : i + 1;
    previous_[i] = i == 0 ? static_cast<Index>(count - 1) : i - 1;
  }
  effort_ = 0;
  // Spikes go first: what looks like an ear at the foot of a spike lies outside the polygon.
  clip_spikes(0, count);
  fill_buckets();

  // When no corner is an ear by one rule, the next one is tried. Only polygons that cut themselves
  // need the last one, by which any corner is clipped.
  enum Rule { kCleanEar, kTouchedEar, kAnything };
  int rule = kCleanEar;
  std::size_t refused = 0;
  Index tip = 1;
  while (next_[tip] == kNone) tip = tip == 0 ? static_cast<Index>(count - 1) : tip - 1;
  while (left_ > 3) {
    const bool tired = effort_ > kMostEffortPerCorner * count;
    if (tired) rule = kAnything;
    if (rule == kAnything || is_ear(tip, rule == kTouchedEar)) {
      const Index before = previous_[tip];
      clip(tip);
      // Clipping spikes, or any corner, may leave corners less convex than they were.
      const bool changed = clip_spikes(before, 2) || rule == kAnything;
      if (left_ * 2 < left_when_filled_ || (changed && !tired)) fill_buckets();
      rule = kCleanEar;
      refused = 0;
      // Go on with the corner after the next one: that gives rounder triangles than a fan.
      tip = before;
      while (next_[tip] == kNone) tip = previous_[tip];
      tip = next_[next_[tip]];
    } else {
      tip = next_[tip];
      if (++refused == left_) {
        ++rule;
        refused = 0;
      }
    }
  }
  clip(tip);
}

}  // namespace kdm
