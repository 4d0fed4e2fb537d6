// SPDX-License-Identifier: MIT
// Keeps, turns, drops and invents crossings along a segment of a grid edge.
#include "inside/resolve_segment.h"

#include <algorithm>

namespace kdm {
namespace {

// Crossings that are less than this far apart form one cluster: 1/64 of a lattice unit, which
// leaves room for an invented crossing between two clusters.
constexpr LinePosition kLeastGap = 64;

constexpr LinePosition position_of(std::int32_t coordinate) {
  return static_cast<LinePosition>(coordinate) << kFractionBits;
}

// Returns the last position below a coordinate, which may be the root's upper end.
constexpr LinePosition last_below(std::int32_t coordinate) { return position_of(coordinate) - 1; }

Vec3 point_at(const Segment& segment, double position) {
  Vec3 p = to_vec3(segment.low);
  p[segment.axis] = position;
  return p;
}

}  // namespace

bool consistent(const Segment& segment, const std::vector<Crossing>& crossings) {
  bool inside = segment.inside_low;
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    if (crossings[i].leaving != inside) return false;
    if (i > 0 && crossings[i].position == crossings[i - 1].position) return false;
    inside = !inside;
  }
  return inside == segment.inside_high;
}

void SegmentResolver::resolve(const Segment& segment, std::vector<Crossing>& crossings, bool invent,
                              std::vector<ClassifiedCrossing>& classified) {
  sort_crossings(crossings);
  if (consistent(segment, crossings) && follows(segment, crossings)) {
    for (const Crossing& c : crossings) {
      classified.emplace_back(c.position, c.triangle, c.leaving ? 0 : 1, CrossingRole::kBounds,
                              c.leaving);
    }
    return;
  }
  find_clusters(segment, crossings);
  bool inside = segment.inside_low;
  LinePosition last = position_of(segment.low[segment.axis]);
  const auto invent_before = [&](LinePosition next, bool inside_next) {
    if (inside == inside_next) return;
    if (invent) {
      const LinePosition position = change_between(segment, last, next, inside);
      classified.emplace_back(position, kNone, inside ? 0 : 1, CrossingRole::kBounds, inside);
    }
    inside = inside_next;
  };
  for (const Cluster& cluster : clusters_) {
    const LinePosition first = crossings[cluster.begin].position;
    if (first - last >= kLeastGap) invent_before(first, cluster.inside_before);
    const bool changes = inside != cluster.inside_after;
    // The one to keep: the first that runs the way of the change, else the first.
    std::size_t keep = cluster.begin;
    while (keep < cluster.end && crossings[keep].leaving != inside) ++keep;
    if (keep == cluster.end) keep = cluster.begin;
    for (std::size_t i = cluster.begin; i < cluster.end; ++i) {
      classified.emplace_back(
          crossings[i].position, crossings[i].triangle, cluster.inside_after ? 1 : 0,
          changes && i == keep ? CrossingRole::kBounds : CrossingRole::kInner, inside);
    }
    inside = cluster.inside_after;
    last = crossings[cluster.end - 1].position;
  }
  invent_before(last_below(segment.high), segment.inside_high);
}

// Groups the crossings and asks the field for the states before and behind each group. If the
// segment leaves no room behind the last cluster, the state behind that is the segment's upper end.
void SegmentResolver::find_clusters(const Segment& segment,
                                    const std::vector<Crossing>& crossings) {
  clusters_.clear();
  LinePosition last = position_of(segment.low[segment.axis]);
  for (std::size_t first = 0; first < crossings.size();) {
    std::size_t next = first + 1;
    while (next < crossings.size() &&
           crossings[next].position - crossings[next - 1].position < kLeastGap) {
      ++next;
    }
    const double gap = (crossings[first].position - last) * kFractionUnit;
    Cluster cluster{first, next, segment.inside_low, segment.inside_low};
    const double begin = real_position(crossings[first].position);
    cluster.inside_before = inside(segment, begin - std::min(0.25, 0.5 * gap));
    last = crossings[next - 1].position;
    const LinePosition end =
        next < crossings.size() ? crossings[next].position : last_below(segment.high);
    const double room = (end - last) * kFractionUnit;
    cluster.inside_after = inside(segment, real_position(last) + std::min(0.25, 0.5 * room));
    clusters_.push_back(cluster);
    first = next;
  }
  if (!clusters_.empty() && last_below(segment.high) - last < kLeastGap) {
    clusters_.back().inside_after = segment.inside_high;
  }
}

// Finds a position strictly between two others at which the state changes: by halving until the
// field is known on both sides of the change, then where a straight line between the two says. A
// step that leaves more than half is followed by halving.
LinePosition SegmentResolver::change_between(const Segment& segment, LinePosition low,
                                             LinePosition high, bool inside_low) const {
  double below = real_position(low);
  double above = real_position(high);
  double excess_below = 0;  // 0: not asked for
  double excess_above = 0;
  bool halve = false;
  while (above - below > precision_) {
    double next = 0.5 * (below + above);
    if (!halve && excess_below != 0 && excess_above != 0) {
      const double room = above - below;
      const double root = room * excess_below / (excess_below - excess_above);
      // A little to the side of the far end, so that the next step comes from there.
      const double beyond = root < 0.5 * room ? 0.4 * precision_ : -0.4 * precision_;
      next = below + std::clamp(root + beyond, 0.4 * precision_, room - 0.4 * precision_);
    }
    const double before = above - below;
    const double excess = field_.excess(point_at(segment, next));
    const bool is_below = (excess > 0) == inside_low;
    (is_below ? below : above) = next;
    (is_below ? excess_below : excess_above) = excess;
    halve = above - below > 0.5 * before;
  }
  const auto position =
      static_cast<LinePosition>(0.5 * (below + above) * static_cast<double>(1 << kFractionBits));
  return std::clamp(position, low + 1, high - 1);
}

bool SegmentResolver::inside(const Segment& segment, double position) const {
  return field_.inside(point_at(segment, position));
}

bool SegmentResolver::follows(const Segment& segment,
                              const std::vector<Crossing>& crossings) const {
  return std::all_of(crossings.begin(), crossings.end(), [&](const Crossing& c) {
    return field_.follows_surface(point_at(segment, real_position(c.position)));
  });
}

}  // namespace kdm
