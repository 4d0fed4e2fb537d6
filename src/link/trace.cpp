// SPDX-License-Identifier: MIT
// Follows the input's surface across a minimal face. The walk goes from a triangle to its neighbour
// over the mesh edge at which the triangle's section with the face's plane ends; which of its edges
// that is, is decided exactly.
#include "link/trace.h"

#include <cmath>

namespace kdm {
namespace {

// Returns which side (0 to 2) of the triangle crosses the plane upwards or, if not `upwards`,
// downwards; 3 if no side does.
int crossing_side(const LatticeTriangle& t, int axis, std::int32_t value, bool upwards) {
  for (int i = 0; i < 3; ++i) {
    const bool from_below = below_plane(t[i][axis], value);
    const bool to_below = below_plane(t[next_corner(i)][axis], value);
    if (from_below != to_below && from_below == upwards) return i;
  }
  return 3;
}

// Tells whether the point where the side crosses the plane is clearly outside the rectangle. The
// point is rounded, so a margin of one lattice unit is left: the answer is only used to end walks
// that cannot arrive.
bool leaves_rectangle(const LatticePoint& a, const LatticePoint& b, int axis, std::int32_t value,
                      const std::array<std::int32_t, 2>& lo,
                      const std::array<std::int32_t, 2>& hi) {
  const double s = static_cast<double>(value - a[axis]) / (b[axis] - a[axis]);
  const std::array<int, 2> across{next_axis(axis), previous_axis(axis)};
  for (int i = 0; i < 2; ++i) {
    const double x = a[across[i]] + s * (b[across[i]] - a[across[i]]);
    if (x < lo[i] - 1.0 || x > hi[i] + 1.0) return true;
  }
  return false;
}

}  // namespace

Traced trace(const Surface& surface, int axis, std::int32_t value,
             const std::array<std::int32_t, 2>& lo, const std::array<std::int32_t, 2>& hi,
             std::span<const TraceEnd> ends, Index start) {
  Index triangle = ends[start].triangle;
  if (triangle == kNone) return {};  // invented
  // With normal N, the section of a triangle runs along N x w from the side that crosses the
  // plane upwards to the one that crosses it downwards. At a side of the rectangle normal to b,
  // (N x w) . b = N . (w x b), and w x b is the direction of the side, up to sign: +v for b = u,
  // -u for b = v. On sides 0 and 3 the rectangle lies towards +b.
  const auto normal = area_vector(surface.triangles[triangle]);
  const int u = next_axis(axis);
  const int v = previous_axis(axis);
  const int side = ends[start].side;
  const bool along_u = side == 0 || side == 2;
  const bool towards_b = along_u ? normal[u] < 0 : normal[v] > 0;
  const bool forward = towards_b == (side == 0 || side == 3);
  // A walk visits a triangle at most once, unless edges of four triangles make it turn in circles.
  for (std::size_t steps = 0; steps <= surface.triangles.size(); ++steps) {
    for (Index end = 0; end < ends.size(); ++end) {
      if (end != start && ends[end].triangle == triangle) return {end, kNone};
    }
    const LatticeTriangle& t = surface.triangles[triangle];
    const int exit = crossing_side(t, axis, value, !forward);
    if (exit == 3) return {};
    if (leaves_rectangle(t[exit], t[next_corner(exit)], axis, value, lo, hi)) return {};
    const Index left_by = 3 * triangle + static_cast<Index>(exit);
    const SideId opposite = surface.topology.opposite[left_by];
    if (opposite == kNone) return {kNone, left_by};
    triangle = opposite / 3;
    if (triangle == ends[start].triangle) return {};
  }
  return {};
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

}  // namespace kdm
