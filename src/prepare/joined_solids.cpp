// SPDX-License-Identifier: MIT
// Puts solids in an order of their own, drops copies, and joins what is left.
#include "prepare/joined_solids.h"

#include <algorithm>
#include <utility>

#include "mesh/boxes.h"
#include "mesh/sort.h"
#include "prepare/extent.h"

namespace kdm {
namespace {

// Compares two solids by what they are like. Returns a negative number if `a` comes first, 0 if
// they are the same.
int compare(const SolidFaces& a, const SolidFaces& b) {
  const auto sign = [](const auto& x, const auto& y) { return x < y ? -1 : y < x ? 1 : 0; };
  const InputFaces& f = a.faces;
  const InputFaces& g = b.faces;
  if (const int s = sign(a.inside, b.inside)) return s;
  if (const int s = sign(f.triangles.size(), g.triangles.size())) return s;
  if (const int s = sign(f.points.size(), g.points.size())) return s;
  for (std::size_t i = 0; i < f.points.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      if (const int s = sign(f.points[i][k], g.points[i][k])) return s;
    }
  }
  for (std::size_t i = 0; i < f.triangles.size(); ++i) {
    if (const int s = sign(f.triangles[i], g.triangles[i])) return s;
  }
  return sign(a.operand == kNone, b.operand == kNone);  // the box has no copies
}

// Returns how large all are together (see find_extent).
double extent_of(std::span<const InputFaces* const> all, const Box& bounds) {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  Topology topology;
  for (const InputFaces* faces : all) {
    const auto first = static_cast<Index>(points.size());
    points.insert(points.end(), faces->points.begin(), faces->points.end());
    for (const Triangle& t : faces->triangles) {
      triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
    topology.components += faces->topology.components;
  }
  return find_extent(triangles, points, topology, bounds).diagonal;
}

template <typename T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

// Numbers the parts of a solid after those of the solids before it.
void append_parts(const Surface& solid, Surface& all) {
  const Index first =
      all.part_of.empty() ? 0 : 1 + *std::max_element(all.part_of.begin(), all.part_of.end());
  if (solid.part_of.empty()) {
    all.part_of.insert(all.part_of.end(), solid.triangles.size(), first);
  } else {
    for (const Index part : solid.part_of) all.part_of.push_back(first + part);
  }
}

// Adds the triangles of a solid to those of others. No point and no side becomes theirs.
void append_solid(const Surface& solid, Index number, Index first_point, Surface& all) {
  const auto first_triangle = static_cast<TriangleId>(all.triangles.size());
  const auto shifted = [&](SideId side) {
    return side == kNone ? kNone : side + 3 * first_triangle;
  };
  append(all.triangles, solid.triangles);
  append(all.points, solid.points);
  append(all.planes, solid.planes);
  append(all.source_faces, solid.source_faces);
  append_parts(solid, all);
  for (const Triangle& t : solid.corners) {
    all.corners.push_back({t[0] + first_point, t[1] + first_point, t[2] + first_point});
  }
  for (std::size_t i = 0; i < solid.triangles.size(); ++i) {
    all.degenerate.push_back(solid.degenerate.test(i));
  }
  Topology& topology = all.topology;
  for (const SideId side : solid.topology.opposite) topology.opposite.push_back(shifted(side));
  for (const SideId side : solid.topology.non_manifold_sides) {
    topology.non_manifold_sides.push_back(shifted(side));
  }
  topology.boundary_edges += solid.topology.boundary_edges;
  topology.non_manifold_edges += solid.topology.non_manifold_edges;
  topology.components += solid.topology.components;
  all.solid_of.resize(all.triangles.size(), number);
  all.patched = all.patched || solid.patched;
}

}  // namespace

JoinedSolids join_solids(std::vector<SolidFaces>& given, const BuildOptions& options,
                         Rounded rounded) {
  const auto before = [&](Index a, Index b) { return compare(given[a], given[b]) < 0; };
  const std::vector<Index> order = in_order(given.size(), Order(before));
  JoinedSolids joined;
  joined.solid_of_given.resize(given.size());
  std::vector<Index> first_of_solid;  // elements of `given`; of equal ones the lowest comes first
  for (const Index i : order) {
    if (first_of_solid.empty() || compare(given[first_of_solid.back()], given[i]) != 0) {
      first_of_solid.push_back(i);
    }
    joined.solid_of_given[i] = static_cast<Index>(first_of_solid.size() - 1);
  }
  Surface& all = joined.surface;
  Box bounds;
  std::vector<const InputFaces*> faces;
  for (const Index i : first_of_solid) {
    faces.push_back(&given[i].faces);
    grow(bounds, given[i].faces.bounds.min);
    grow(bounds, given[i].faces.bounds.max);
  }
  all.lattice = lattice_for(bounds, options);
  all.extent = extent_of(faces, bounds);
  std::vector<InputReport> reports(first_of_solid.size());
  Index points = 0;
  for (Index solid = 0; solid < first_of_solid.size(); ++solid) {
    SolidFaces& one = given[first_of_solid[solid]];
    const auto next = points + static_cast<Index>(one.faces.points.size());
    std::shared_ptr<const Surface> surface = one.rounded;
    if (surface == nullptr || surface->lattice != all.lattice) {
      surface = std::make_shared<Surface>(surface_of(std::move(one.faces), all.lattice, false));
    }
    append_solid(*surface, solid, points, all);
    points = next;
    reports[solid] = surface->report;
    one.rounded = rounded == Rounded::kKept ? std::move(surface) : nullptr;
    joined.rules.push_back(one.inside);
    all.operand_of_solid.push_back(one.operand);
  }
  const bool one_part =
      std::all_of(all.part_of.begin(), all.part_of.end(), [](Index part) { return part == 0; });
  if (one_part) all.part_of.clear();
  for (std::size_t i = 0; i < given.size(); ++i) {
    given[i].faces.report = reports[joined.solid_of_given[i]];
  }
  return joined;
}

InputReport sum_of(std::span<const InputReport> reports) {
  InputReport sum;
  sum.closed = sum.nesting_known = true;
  for (const InputReport& r : reports) {
    sum.vertices += r.vertices;
    sum.triangles += r.triangles;
    sum.closed = sum.closed && r.closed;
    sum.boundary_edges += r.boundary_edges;
    sum.boundary_loops += r.boundary_loops;
    sum.non_manifold_edges += r.non_manifold_edges;
    sum.degenerate_faces += r.degenerate_faces;
    sum.cancelled_faces += r.cancelled_faces;
    sum.duplicate_faces += r.duplicate_faces;
    sum.sewn_edges += r.sewn_edges;
    sum.turned_faces += r.turned_faces;
    sum.turned_parts += r.turned_parts;
    sum.nesting_known = sum.nesting_known && r.nesting_known;
    sum.components += r.components;
    sum.flipped = sum.flipped || r.flipped;
    sum.patched_holes += r.patched_holes;
    sum.patch_area += r.patch_area;
    sum.lost_parts += r.lost_parts;
    sum.lost_area += r.lost_area;
    sum.largest_lost = std::max(sum.largest_lost, r.largest_lost);
    sum.thickened_parts += r.thickened_parts;
    sum.rebuilt_parts += r.rebuilt_parts;
    sum.rebuilding_tolerance = std::max(sum.rebuilding_tolerance, r.rebuilding_tolerance);
    sum.sewing_distance = std::max(sum.sewing_distance, r.sewing_distance);
    sum.stray_parts += r.stray_parts;
  }
  return sum;
}

}  // namespace kdm
