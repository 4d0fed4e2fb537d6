// SPDX-License-Identifier: MIT
// Tests points. The middles of triangles need none: where edges are near and samples fit, they
// never failed.
#include "reduce/near_test.h"

#include <algorithm>

namespace kdm {
namespace {

// How far points along an edge are apart, in allowed distances, and how many there are at most.
// With 8 instead of 4 results are up to 1.5 times as far off as asked for.
constexpr double kSpacing = 4;
constexpr int kMostPieces = 32;

bool points_are_near(const KeptDistance& kept, const Vec3& from, const Vec3& to, double limit,
                     TriangleId hint) {
  const double length = (to - from).norm();
  const double spacing = kSpacing * kept.error;
  const int pieces = std::clamp(static_cast<int>(length / spacing) + 1, 2, kMostPieces);
  for (int i = 1; i < pieces; ++i) {
    const Vec3 point = from + (static_cast<double>(i) / pieces) * (to - from);
    if (!kept.reference->is_near(point, limit, hint)) return false;
  }
  return true;
}

}  // namespace

bool stays_near(const Workpiece& piece, const CollapseRing& ring, NearFind& found) {
  const KeptDistance& kept = *piece.distance;
  const double limit = std::min(kept.limits[ring.kept], kept.limits[ring.removed]);
  found.near = kept.near[ring.kept];
  if (!kept.samples.fit(ring, limit, found.places)) return false;
  if (!kept.reference->is_near(ring.point, limit, found.near)) return false;
  const bool on_rim = piece.mesh.on_boundary(ring.kept) || piece.mesh.on_boundary(ring.removed);
  for (std::size_t i = 0; i < ring.triangles.size(); ++i) {
    const RingTriangle& t = ring.triangles[i];
    const TriangleId hint = found.places.hint(i);
    if (!points_are_near(kept, ring.point, t.from_point, limit,
                         hint != kNone ? hint : kept.near[t.from])) {
      return false;
    }
    // On a rim one edge begins no triangle of the ring.
    if (on_rim && !points_are_near(kept, ring.point, t.to_point, limit, kept.near[t.to])) {
      return false;
    }
  }
  return true;
}

bool edge_stays_near(const Workpiece& piece, VertexId from, VertexId to) {
  const KeptDistance& kept = *piece.distance;
  return points_are_near(kept, piece.positions[from], piece.positions[to],
                         std::min(kept.limits[from], kept.limits[to]), kept.near[from]);
}

}  // namespace kdm
