// SPDX-License-Identifier: MIT
// Feature points of a cell and of its half-faces, and the split that serves most of them.
//
// What the paper leaves open and we decided: a quadric counts with the coordinates that its
// significant eigenvectors determine, so a crease counts across, not along its direction, and flat
// parts not at all; the split goes through the point with the most others near it; and it keeps a
// sixteenth of the cell's width away from its sides, since a feature so near is as well served.
#include "split/feature_point.h"

#include <algorithm>
#include <cmath>

#include "geometry/quadric.h"
#include "geometry/triangle_box.h"

namespace kdm {
namespace {

// A feature helps a split within this fraction of the cell's width.
constexpr double kReach = 1.0 / 8;
constexpr double kMargin = 1.0 / 16;

}  // namespace

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
  if (certainty.sum() < 1.5) return;  // one direction only: flat
  features_.push_back({quadric.minimiser_in(to_vec3(box.lo), to_vec3(box.hi)), certainty});
}

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
    // The ends of the triangle's section with the face's plane.
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
    // The triangle's plane, turned upright on the face, meets it in the same line.
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
  if (certainty.sum() < 1.5) return;
  certainty[axis] = 0;  // the face is there already
  LatticeBox face = box;
  face.lo[axis] = face.hi[axis] = plane;
  features_.push_back({quadric.minimiser_in(to_vec3(face.lo), to_vec3(face.hi)), certainty});
}

double FeatureFinder::score(const LatticeBox& box, int axis, double value) const {
  const double reach = kReach * (box.hi[axis] - box.lo[axis]);
  double sum = 0;
  for (const Feature& feature : features_) {
    const double near = 1 - std::abs(feature.point[axis] - value) / reach;
    if (near > 0) sum += near * feature.certainty[axis];
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
  double most = 0;
  double longest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    longest = std::max(longest, static_cast<double>(box.hi[axis] - box.lo[axis]));
  }
  for (int axis = 0; axis < 3; ++axis) {
    const double low = box.lo[axis];
    const double extent = box.hi[axis] - low;
    if (extent < 2) continue;
    const double margin = std::max(kMargin * extent, 1.0);
    for (const Feature& feature : features_) {
      if (!(feature.certainty[axis] > 0.5)) continue;
      const double value = std::clamp(feature.point[axis], low + margin, low + extent - margin);
      // Of splits that serve as much, the one across the longer side makes the better cells.
      const double worth = score(box, axis, value) * extent / longest;
      if (worth <= most) continue;
      most = worth;
      // A vertex on a split counts as below it: the feature's own triangles stay together there.
      best = Split{axis, std::clamp(static_cast<std::int32_t>(std::floor(value + 0.5)),
                                    box.lo[axis] + 1, box.hi[axis] - 1)};
    }
  }
  return best;
}

}  // namespace kdm
