// SPDX-License-Identifier: MIT
// Compares for each part the area of its patches with its own area and with the volume that both
// enclose.
#include "prepare/sheets.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/boxes.h"
#include "mesh/groups.h"
#include "mesh/joined.h"
#include "mesh/measure.h"
#include "mesh/scale.h"
#include "mesh/sides.h"
#include "prepare/outside_in.h"
#include "threads/share_work.h"

namespace kdm {
namespace {

// A part is a sheet if the patches have more than this share of its area, and nearly all of that is
// one patch's. Of half a ball it has half.
constexpr double kMostForOnePatch = 0.85;
constexpr double kOfOnePatch = 0.8;
// The same if there are several patches. Of a tube as long as it is thick they have half.
constexpr double kMostForSeveral = 3;
// What a part must enclose if its patches have more than this share of its area: the volume
// divided by area^(3/2), which is 0.09 for a ball.
constexpr double kLargePatches = 0.25;
constexpr double kLeastVolume = 1e-3;

// If the patches have more than this share of the part's area, it is looked whether they turn more
// than this share of it outside in, and of the whole area.
constexpr double kHarmlessPatches = 0.02;
constexpr double kMostOutsideIn = 0.1;
constexpr double kMostOfAll = 0.01;
constexpr Index kSamples = 128;

struct OpenPart {
  Box bounds;
  Measure own;
  Measure closed;  // with the patches
  double seen_from_both_sides = 0;
  Index patches = 0;
  double largest_patch = 0;
};

bool is_sheet(const OpenPart& part) {
  if (part.patches == 0) return false;
  const double area = part.own.area;
  const double patched = part.closed.area - area;
  if (2 * part.seen_from_both_sides > area) return true;
  const bool one_patch = part.largest_patch >= kOfOnePatch * patched;
  if (patched > (one_patch ? kMostForOnePatch : kMostForSeveral) * area) return true;
  const double unit = area * std::sqrt(area);
  return patched > kLargePatches * area && !(std::abs(part.closed.volume) > kLeastVolume * unit);
}

// Marks the parts that are no sheets, but of which patches turn too much outside in.
Marks find_turned(const std::vector<OpenPart>& parts, const Marks& is_a_sheet,
                  std::span<const Index> part_of, std::span<const Triangle> triangles,
                  std::span<const Index> part_of_patch, const std::vector<Patch>& patches,
                  const std::vector<Vec3>& positions) {
  const Groups triangles_of(parts.size(), [&](const auto& put) {
    for (TriangleId t = 0; t < triangles.size(); ++t) put(part_of[t], t);
  });
  const Groups patches_of(parts.size(), [&](const auto& put) {
    for (Index i = 0; i < patches.size(); ++i) put(part_of_patch[i], i);
  });
  double whole = 0;
  for (const OpenPart& part : parts) whole += part.own.area;
  Marks turned(parts.size());
  share_work(parts.size(), workers(), [&](std::size_t number, int) {
    const auto p = static_cast<Index>(number);
    const double patched = parts[p].closed.area - parts[p].own.area;
    if (is_a_sheet.test(p) || !(patched > kHarmlessPatches * parts[p].own.area)) return;
    std::vector<Triangle> closed;
    for (const TriangleId t : triangles_of.of(p)) closed.push_back(triangles[t]);
    std::vector<TriangleId> own(closed.size());
    std::iota(own.begin(), own.end(), TriangleId{0});
    for (const Index i : patches_of.of(p)) {
      closed.insert(closed.end(), patches[i].triangles.begin(), patches[i].triangles.end());
    }
    const Sight sight(closed, positions, Marks(closed.size()));
    double share = share_outside_in(closed, positions, sight, own, kSamples);
    if (parts[p].closed.volume < 0) share = std::min(share, 1 - share);  // it may be turned itself
    turned.set(p, share > kMostOutsideIn && share * parts[p].own.area > kMostOfAll * whole);
  });
  return turned;
}

}  // namespace

Sheets find_sheets(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                   std::span<const SideId> opposite, const std::vector<Hole>& holes,
                   const std::vector<Patch>& patches, const Marks& seen_from_both_sides) {
  DisjointSets sets = join_triangles(opposite);
  const auto triangle_at = [&](Index hole) { return triangle_of(holes[hole].sides[0]); };
  for (const Patch& patch : patches) {
    for (const Index hole : patch.holes) sets.join(triangle_at(patch.holes[0]), triangle_at(hole));
  }
  std::vector<OpenPart> parts(sets.count());
  const std::vector<Index> part_of = number_sets(sets, triangles.size());
  const ScaledPositions scaled = scale_to_one(points, triangles);
  std::vector<Index> part_of_patch;
  for (const Patch& patch : patches) part_of_patch.push_back(part_of[triangle_at(patch.holes[0])]);
  const auto add = [&](const Triangle& t, Measure& to) {
    to.add(scaled.positions[t[0]], scaled.positions[t[1]], scaled.positions[t[2]]);
  };
  for (TriangleId t = 0; t < triangles.size(); ++t) {
    for (const PointId p : triangles[t]) grow(parts[part_of[t]].bounds, scaled.positions[p]);
  }
  for (OpenPart& part : parts) part.own.centre = centre_of(part.bounds);
  for (TriangleId t = 0; t < triangles.size(); ++t) {
    OpenPart& part = parts[part_of[t]];
    const double before = part.own.area;
    add(triangles[t], part.own);
    if (seen_from_both_sides.test(t)) part.seen_from_both_sides += part.own.area - before;
  }
  for (OpenPart& part : parts) part.closed = part.own;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    OpenPart& part = parts[part_of_patch[i]];
    ++part.patches;
    const double before = part.closed.area;
    for (const Triangle& t : patches[i].triangles) add(t, part.closed);
    part.largest_patch = std::max(part.largest_patch, part.closed.area - before);
  }

  Sheets sheets;
  Marks is_a_sheet;
  const auto area_of = [&](const OpenPart& part) {
    return std::ldexp(part.own.area, 2 * scaled.exponent);
  };
  for (const OpenPart& part : parts) {
    is_a_sheet.push_back(is_sheet(part));
    if (!is_sheet(part)) {
      sheets.area_of_solids += area_of(part);
      continue;
    }
    ++sheets.parts;
    sheets.area += area_of(part);
    sheets.largest = std::max(sheets.largest, area_of(part));
  }
  for (const Index part : part_of) sheets.triangles.push_back(is_a_sheet.test(part));
  const Marks turned =
      find_turned(parts, is_a_sheet, part_of, triangles, part_of_patch, patches, scaled.positions);
  for (const Index part : part_of_patch) {
    sheets.useless_patches.push_back(is_a_sheet.test(part) || turned.test(part));
    const double patched = parts[part].closed.area - parts[part].own.area;
    sheets.wide_patches.push_back(patched > kLargePatches * parts[part].own.area);
  }
  return sheets;
}

}  // namespace kdm
