// SPDX-License-Identifier: MIT
// Finds the feature points of a cell and of its half-faces, and the split that serves most of them.
//
// The paper leaves three things open, which we decided as follows.
// Weight. A feature point counts along an axis as far as the significant eigenvectors of its
// quadric determine that coordinate. So a crease counts across its direction and not along it, and
// a flat part of the surface does not count. Choice. The split goes through the feature point with
// the most other feature points near it. Margin. The split keeps away from the sides of the cell,
// since a feature point near a side is served by that side.
#include "split/feature_point.h"

#include <algorithm>
#include <cmath>

#include "geometry/quadric.h"
#include "geometry/triangle_box.h"

namespace kdm {
namespace {

// A split serves the feature points that lie within this fraction of the cell's width from it.
constexpr double kReach = 1.0 / 8;
// A split keeps this fraction of the cell's width away from the sides of the cell.
constexpr double kMargin = 1.0 / 16;
// A quadric is that of a feature if the certainties of its minimiser's coordinates add up to this.
// Nearly parallel planes give about 1, a crease gives 2, a corner 3.
constexpr double kLeastCertainty = 1.5;
// A split goes through a feature point only across axes along which its certainty is above this.
constexpr double kLeastCertaintyAcross = 0.5;

}  // namespace

// Finds the feature point of the triangles that lie wholly in the cell, if there is one.
void FeatureFinder::find_in_cell(const LatticeBox& box, std::span<const ListEntry> entries) {
  const Vec3 centre = 0.5 * (to_vec3(box.lo) + to_vec3(box.hi));
  PrimalQuadric quadric(centre);
  bool any = false;
  for (const ListEntry& entry : entries) {
    const LatticeTriangle& t = surface_.triangles[entry.triangle];
    if (surface_.degenerate.test(entry.triangle)) continue;
    if (!std::all_of(t.begin(), t.end(), [&](const auto& p) { return vertex_in_box(p, box); })) {
      continue;
    }
    quadric.add(surface_.planes[entry.triangle]);
    any = true;
  }
  if (!any) return;
  const Vec3 certainty = quadric.certainty();
  if (certainty.sum() < kLeastCertainty) return;
  features_.push_back({quadric.minimiser_in(to_vec3(box.lo), to_vec3(box.hi)), certainty});
}

// Finds the feature point of the lines in which triangles cut the cell's low or high side across
// `axis`, if there is one.
void FeatureFinder::find_on_half_face(const LatticeBox& box, std::span<const ListEntry> entries,
                                      int axis, bool high) {
  const std::int32_t plane = high ? box.hi[axis] : box.lo[axis];
  const int u = next_axis(axis);
  const int v = previous_axis(axis);
  PrimalQuadric quadric(0.5 * (to_vec3(box.lo) + to_vec3(box.hi)));
  bool any = false;
  for (const ListEntry& entry : entries) {
    const LatticeTriangle& t = surface_.triangles[entry.triangle];
    if (surface_.degenerate.test(entry.triangle)) continue;
    if (high ? entry.hi[axis] < plane : entry.lo[axis] > plane) continue;
    // The triangle cuts the side's plane in a segment; both its ends must lie within the side.
    bool inside = true;
    int ends = 0;
    for (int i = 0; i < 3; ++i) {
      const LatticePoint& a = t[i];
      const LatticePoint& b = t[i == 2 ? 0 : i + 1];
      if (below_plane(a[axis], plane) == below_plane(b[axis], plane)) continue;
      const double share = static_cast<double>(plane - a[axis]) / (b[axis] - a[axis]);
      const double at_u = a[u] + share * (b[u] - a[u]);
      const double at_v = a[v] + share * (b[v] - a[v]);
      inside =
          inside && at_u > box.lo[u] && at_u < box.hi[u] && at_v > box.lo[v] && at_v < box.hi[v];
      ++ends;
    }
    if (ends != 2 || !inside) continue;
    // The plane through the segment that stands upright on the side takes the place of the
    // triangle's plane.
    Plane line = surface_.planes[entry.triangle];
    line.offset -= line.normal[axis] * plane;
    line.normal[axis] = 0;
    const double length = line.normal.norm();
    if (!(length > 0)) continue;
    quadric.add({line.normal / length, line.offset / length});
    any = true;
  }
  if (!any) return;
  Vec3 certainty = quadric.certainty();
  if (certainty.sum() < kLeastCertainty) return;
  certainty[axis] = 0;  // a split through the half-face is there already
  LatticeBox face = box;
  face.lo[axis] = face.hi[axis] = plane;
  features_.push_back({quadric.minimiser_in(to_vec3(face.lo), to_vec3(face.hi)), certainty});
}

// Returns how much a split at `value` serves the feature points: the sum of their certainties
// across the axis, each times a factor that falls from 1 at the split to 0 at the reach.
double FeatureFinder::usefulness(const LatticeBox& box, int axis, double value) const {
  const double reach = kReach * (box.hi[axis] - box.lo[axis]);
  double sum = 0;
  for (const Feature& feature : features_) {
    const double nearness = 1 - std::abs(feature.point[axis] - value) / reach;
    if (nearness > 0) sum += nearness * feature.certainty[axis];
  }
  return sum;
}

std::optional<Split> FeatureFinder::propose(const LatticeBox& box,
                                            std::span<const ListEntry> entries) {
  features_.clear();
  find_in_cell(box, entries);
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool high : {false, true}) find_on_half_face(box, entries, axis, high);
  }
  std::optional<Split> best;
  double most_worth = 0;
  double longest_extent = 0;
  for (int axis = 0; axis < 3; ++axis) {
    longest_extent = std::max(longest_extent, static_cast<double>(box.hi[axis] - box.lo[axis]));
  }
  for (int axis = 0; axis < 3; ++axis) {
    const double low = box.lo[axis];
    const double extent = box.hi[axis] - low;
    if (extent < 2) continue;
    const double margin = std::max(kMargin * extent, 1.0);
    for (const Feature& feature : features_) {
      if (!(feature.certainty[axis] > kLeastCertaintyAcross)) continue;
      const double value = std::clamp(feature.point[axis], low + margin, low + extent - margin);
      // Of two splits that are equally useful, the one across the longer extent makes cells of the
      // better proportions.
      const double worth = usefulness(box, axis, value) * extent / longest_extent;
      if (worth <= most_worth) continue;
      most_worth = worth;
      // The split may go right through the feature point: a vertex at its value counts as below it.
      best = Split{axis, std::clamp(static_cast<std::int32_t>(std::floor(value + 0.5)),
                                    box.lo[axis] + 1, box.hi[axis] - 1)};
    }
  }
  return best;
}

}  // namespace kdm
