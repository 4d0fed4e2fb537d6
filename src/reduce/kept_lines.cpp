// SPDX-License-Identifier: MIT
// A stretch of border and the edge in its place are within a distance of each other, both ways, if
// the vertices that the stretch had are: what lies between two points near to a segment is as near.
#include "reduce/kept_lines.h"

#include <algorithm>

#include "geometry/distance.h"

namespace kdm {

KeptLines::KeptLines(const Workpiece& piece) : piece_(piece) {
  const HalfEdges& mesh = piece.mesh;
  for (SideId h = 0; h < 3 * mesh.triangles(); ++h) {
    if (mesh.is_removed(triangle_of(h)) || !is_line(h) || piece.is_fixed(mesh.start(h))) continue;
    any_ = true;
    if (!piece.distance || !piece.is_border(h)) continue;
    const VertexId from = mesh.start(h);
    const VertexId to = mesh.end(h);
    if (from < to) put(from, to, {piece.positions[from], piece.positions[to]});
  }
}

KeptLines::Place KeptLines::place_at(VertexId v) const {
  int rims = 0;
  int borders = 0;
  piece_.mesh.for_each_leaving(v, [&](SideId h) {
    if (piece_.mesh.opposite(h) == kNone) ++rims;
    if (piece_.mesh.opposite(previous_side(h)) == kNone) ++rims;
    if (piece_.is_border(h)) ++borders;
  });
  if (rims + borders == 0) return Place::kFree;
  return rims + borders == 2 ? Place::kOnLine : Place::kCorner;
}

std::optional<CollapsePlace> KeptLines::place_of(SideId edge) const {
  if (!any_) return CollapsePlace::kBest;
  const Place start = place_at(piece_.mesh.start(edge));
  const Place end = place_at(piece_.mesh.end(edge));
  if (start != Place::kFree && end != Place::kFree && !is_line(edge)) return std::nullopt;
  if (start != end) return start > end ? CollapsePlace::kStart : CollapsePlace::kEnd;
  if (start == Place::kCorner) return std::nullopt;
  return CollapsePlace::kBest;
}

bool KeptLines::would_merge(SideId edge) const {
  if (!any_) return false;
  for (const SideId side : {edge, piece_.mesh.opposite(edge)}) {
    if (side != kNone && is_line(next_side(side)) && is_line(previous_side(side))) return true;
  }
  return false;
}

KeptLines::Stretch KeptLines::stretch(VertexId from, VertexId to) const {
  Stretch points = stretches_.at(std::minmax(from, to));
  if (from > to) std::reverse(points.begin(), points.end());
  return points;
}

void KeptLines::put(VertexId from, VertexId to, Stretch points) {
  if (from > to) std::reverse(points.begin(), points.end());
  stretches_[std::minmax(from, to)] = std::move(points);
}

// Returns the other vertex that a border leads to; kNone if it is a corner.
VertexId KeptLines::next_on_border(VertexId from, VertexId not_to) const {
  if (place_at(from) == Place::kCorner) return kNone;
  VertexId next = kNone;
  piece_.mesh.for_each_leaving(from, [&](SideId h) {
    if (piece_.is_border(h) && piece_.mesh.end(h) != not_to) next = piece_.mesh.end(h);
  });
  return next;
}

bool KeptLines::stay_near(SideId edge, const CollapseRing& ring, double distance, Cut& cut) const {
  if (!piece_.is_border(edge)) return true;
  const VertexId before = next_on_border(ring.kept, ring.removed);
  const VertexId after = next_on_border(ring.removed, ring.kept);
  Stretch& joined = cut.points;
  joined = stretch(ring.kept, ring.removed);
  const auto distance_from = [&](std::size_t i) { return (joined[i] - ring.point).squaredNorm(); };
  if (before != kNone) {
    Stretch whole = stretch(before, ring.kept);
    whole.insert(whole.end(), joined.begin() + 1, joined.end());
    joined = std::move(whole);
  }
  if (after != kNone) {
    const Stretch more = stretch(ring.removed, after);
    joined.insert(joined.end(), more.begin() + 1, more.end());
  }
  // A corner stays where it is, and the stretch ends there.
  cut.at = before == kNone ? 0 : joined.size() - 1;
  if (before != kNone && after != kNone) {
    cut.at = 0;
    for (std::size_t i = 1; i < joined.size(); ++i) {
      if (distance_from(i) < distance_from(cut.at)) cut.at = i;
    }
  }
  const double limit = distance * distance;
  const auto is_near = [&](std::size_t first, std::size_t last, VertexId end) {
    const Vec3& far = end == kNone ? ring.point : piece_.positions[end];
    for (std::size_t i = first; i <= last; ++i) {
      if (squared_distance(joined[i], ring.point, far) > limit) return false;
    }
    return true;
  };
  return is_near(0, cut.at, before) && is_near(cut.at, joined.size() - 1, after);
}

void KeptLines::collapsing(SideId edge, const CollapseRing& ring, const Cut& cut) {
  if (stretches_.empty()) return;
  const bool along = piece_.is_border(edge);
  const VertexId before = along ? next_on_border(ring.kept, ring.removed) : kNone;
  const VertexId after = along ? next_on_border(ring.removed, ring.kept) : kNone;
  if (along) stretches_.erase(std::minmax(ring.kept, ring.removed));
  // The vertex that goes leaves its lines to the one that stays.
  std::vector<VertexId> ends;
  piece_.mesh.for_each_leaving(ring.removed, [&](SideId h) {
    if (h != edge && piece_.is_border(h) && piece_.mesh.end(h) != ring.kept) {
      ends.push_back(piece_.mesh.end(h));
    }
  });
  for (const VertexId end : ends) {
    put(ring.kept, end, stretch(ring.removed, end));
    stretches_.erase(std::minmax(ring.removed, end));
  }
  if (!along) return;
  const auto middle = cut.points.begin() + static_cast<std::ptrdiff_t>(cut.at);
  if (before != kNone) put(before, ring.kept, Stretch(cut.points.begin(), middle + 1));
  if (after != kNone) put(ring.kept, after, Stretch(middle, cut.points.end()));
}

}  // namespace kdm
