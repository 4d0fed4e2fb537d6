// SPDX-License-Identifier: MIT
// Links, traces and tangent lines of hits on a minimal face.
#include "link/outline.h"

#include <cmath>

#include "geometry/assert.h"

namespace kdm {

void link(const MinimalFace& face, const OutlineHit& a, const OutlineHit& b, GridData& grid) {
  KDM_ASSERT(compatible(a, b), "linked half-edges run against each other");
  const std::uint32_t strip = face.strip() ? GridData::kStrip : 0;
  grid.opposite[a.half_edge] = b.half_edge;
  grid.opposite[b.half_edge] = a.half_edge;
  grid.start[a.half_edge] = (a.starts_below ? face.below : face.above) | strip;
  grid.start[b.half_edge] = (b.starts_below ? face.below : face.above) | strip;
}

void link_strip(const MinimalFace& face, GridData& grid) {
  const int first = face.lo(0) == face.hi(0) ? 1 : 0;
  const FaceEdge& a = face.edges[first];
  const FaceEdge& b = face.edges[first + 2];
  KDM_ASSERT(a.hits.size() == b.hits.size(), "the long sides of a strip carry the same hits");
  for (Index i = 0; i < a.hits.size(); ++i) {
    link(face, outline_hit(grid, a, a.hits.first + i, first),
         outline_hit(grid, b, b.hits.first + i, first + 2), grid);
  }
}

void trace_outline(const Surface& surface, std::span<const TriangleId> triangle_of_hit,
                   const MinimalFace& face, const std::vector<OutlineHit>& outline,
                   std::vector<Traced>& traced) {
  std::vector<TraceEnd> ends;
  ends.reserve(outline.size());
  for (const OutlineHit& h : outline) ends.push_back({triangle_of_hit[h.hit], h.side});
  const std::array<std::int32_t, 2> lo{face.lo(0), face.lo(1)};
  const std::array<std::int32_t, 2> hi{face.hi(0), face.hi(1)};
  traced.clear();
  for (Index i = 0; i < outline.size(); ++i) {
    traced.push_back(trace(surface, face.axis, face.plane, lo, hi, ends, i));
  }
  std::vector<Index> found;
  found.reserve(traced.size());
  for (const Traced& t : traced) found.push_back(t.end);
  for (Index i = 0; i < traced.size(); ++i) {
    const Index j = found[i];
    const bool mutual = j != kNone && found[j] == i && compatible(outline[i], outline[j]);
    if (!mutual) traced[i].end = kNone;
  }
}

void find_tangents(const GridData& grid, const MinimalFace& face,
                   const std::vector<OutlineHit>& outline, std::vector<Tangent>& tangents) {
  tangents.clear();
  const int u = next_axis(face.axis);
  const int v = previous_axis(face.axis);
  for (const OutlineHit& h : outline) {
    const double along = real_position(grid.hits[h.hit].position);
    Tangent t{along, along, 0, 0};
    if (h.side == 0 || h.side == 2) {
      t.v = h.side == 0 ? face.lo(1) : face.hi(1);
    } else {
      t.u = h.side == 3 ? face.lo(0) : face.hi(0);
    }
    const Vec3& normal = grid.plane_of(h.hit).normal;
    const double length = std::sqrt(normal[u] * normal[u] + normal[v] * normal[v]);
    if (length > 0) {
      t.nu = normal[u] / length;
      t.nv = normal[v] / length;
    }
    tangents.push_back(t);
  }
}

double deviation(const Tangent& a, const Tangent& b) {
  const double du = b.u - a.u;
  const double dv = b.v - a.v;
  const double from_a = a.nu * du + a.nv * dv;
  const double from_b = b.nu * du + b.nv * dv;
  return from_a * from_a + from_b * from_b + 1e-6 * (du * du + dv * dv);
}

}  // namespace kdm
