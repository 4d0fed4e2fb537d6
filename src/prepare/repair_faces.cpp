// SPDX-License-Identifier: MIT
// Sews, turns, patches and leaves out, in this order.
#include "prepare/repair_faces.h"

#include "text/compose.h"

#include <algorithm>

#include "kdmanifold/error.h"
#include "mesh/boundary_loops.h"
#include "mesh/boxes.h"
#include "mesh/sides.h"
#include "prepare/edit_faces.h"
#include "prepare/extent.h"
#include "prepare/holes.h"
#include "prepare/inverted_parts.h"
#include "prepare/non_manifold_edges.h"
#include "prepare/orient.h"
#include "prepare/patches.h"
#include "prepare/sew.h"
#include "prepare/sheets.h"
#include "prepare/thicken_faces.h"

namespace kdm {
namespace {

// Holes whose corners are within this part of the tolerance of a plane are closed by flat patches.
constexpr double kFlatness = 0.25;
// Sheets are left out only if they have no more than this share of the whole area. Otherwise they
// may be what the model consists of: walls that do not meet exactly.
constexpr double kMostLost = 0.05;

// How far rims that are torn apart are sewn, in tolerances.
constexpr double kMostTorn = 16;

void sew(InputFaces& faces, double tolerance) {
  if (faces.topology.boundary_edges == 0) return;
  double reach = tolerance;
  Index& sewn = faces.report.sewn_edges;
  sewn = sew_rims(reach, faces.triangles, faces.points, faces.topology);
  const double torn =
      torn_distance(kMostTorn * tolerance, faces.triangles, faces.points, faces.topology);
  if (torn > tolerance) {
    reach = torn;
    sewn += sew_rims(reach, faces.triangles, faces.points, faces.topology);
  }
  if (sewn > 0) faces.report.sewing_distance = reach;
  const Index dropped = drop_repeated_corners(faces);
  if (faces.triangles.empty()) {
    throw Error(ErrorCode::kNotClosed,
                "the surface encloses nothing that is wider than the tolerance; thicken it, or "
                "take it as a sheet");
  }
  if (dropped > 0) find_topology(faces);
}

// Turns faces so that neighbours agree and parts look outwards. Of several faces over the same
// corners one is kept. Returns which of the faces that are left belong to open parts that are seen
// from both sides alike.
Marks turn_outwards(InputFaces& faces) {
  const Orientation orientation = orient(faces.triangles, faces.points, faces.topology);
  turn_faces(faces, orientation.must_turn);
  Marks seen_from_both_sides;
  Marks copies;
  for (std::size_t i = 0; i < faces.triangles.size(); ++i) {
    copies.push_back(orientation.copy_of[i] != kNone);
    if (copies.test(i)) continue;
    const OrientedPart& part = orientation.parts[orientation.part[i]];
    seen_from_both_sides.push_back(part.sheet && !part.closed);
  }
  if (!orientation.changes_nothing() || orientation.copies > 0) {
    drop_faces(faces, copies);
    find_topology(faces);
  }
  faces.report.turned_faces = orientation.flipped_triangles;
  faces.report.duplicate_faces = orientation.copies;
  return seen_from_both_sides;
}

// Throws if a hole's bounding box has a diagonal of more than `largest`, in model units.
void check_holes(const std::vector<BoundaryLoop>& holes, const InputFaces& faces, double largest) {
  Index too_wide = 0;
  double widest = 0;
  Vec3 place = Vec3::Zero();
  for (const BoundaryLoop& hole : holes) {
    const auto corner = [&](SideId side) {
      return faces.points[faces.triangles[triangle_of(side)][corner_of(side)]];
    };
    Box bounds;
    for (const SideId side : hole.vertices) grow(bounds, corner(side));
    const double width = (bounds.max - bounds.min).norm();
    too_wide += width > largest ? 1 : 0;
    if (width <= widest) continue;
    widest = width;
    place = corner(hole.vertices[0]);
  }
  if (too_wide == 0) return;
  throw Error(ErrorCode::kNotClosed,
              compose("{} of {} holes are wider than `largest_hole`, which is {}; the widest, {} "
                      "across, passes through ({}, {}, {}): allow wider ones, thicken the "
                      "surface, or take it as a sheet",
                      too_wide, holes.size(), largest, widest, place[0], place[1], place[2]));
}

void add_patch(const Patch& patch, InputFaces& faces) {
  for (const Triangle& t : patch.triangles) {
    faces.triangles.push_back(t);
    faces.source_faces.push_back(patch.narrow ? kNone : kPatch);
    faces.patch_planes.push_back({patch.normal, patch.point});
  }
  faces.report.patched_holes += static_cast<Index>(patch.holes.size());
  faces.report.patch_area += patch.area;
}

// Closes the holes of solids, and leaves sheets out unless they have much area.
// Where `thickness` is above 0, sheets get that thickness instead.
void close_holes(InputFaces& faces, const Marks& seen_from_both_sides, double tolerance,
                 double thickness) {
  const std::vector<Hole> holes =
      find_holes(faces.triangles, static_cast<Index>(faces.points.size()), faces.topology.opposite);
  const std::vector<Patch> patches =
      make_patches(faces.triangles, faces.points, holes, kFlatness * tolerance);
  const Sheets sheets = find_sheets(faces.triangles, faces.points, faces.topology.opposite, holes,
                                    patches, seen_from_both_sides);
  const bool thickens = sheets.parts > 0 && thickness > 0;
  const bool negligible =
      thickens || (sheets.area_of_solids > 0 &&
                   sheets.area <= kMostLost * (sheets.area + sheets.area_of_solids));
  if (thickens) {
    thicken_faces(faces, sheets.triangles, thickness);
    faces.bounds = bounds_of(faces);
    faces.report.thickened_parts = sheets.parts;
  } else if (sheets.parts > 0 && negligible) {
    drop_faces(faces, sheets.triangles);
    faces.bounds = bounds_of(faces);
    faces.report.lost_parts = sheets.parts;
    faces.report.lost_area = sheets.area;
    faces.report.largest_lost = sheets.largest;
  }
  // If sheets stay, winding numbers close what is left open. They make more of wide mouths, behind
  // which sheets may lie.
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const bool useless =
        sheets.useless_patches.test(i) || (!negligible && sheets.wide_patches.test(i));
    if (!useless) add_patch(patches[i], faces);
  }
  find_topology(faces);
  if (faces.report.lost_parts > 0) {
    faces.report.extent =
        find_extent(faces.triangles, faces.points, faces.topology, faces.bounds).diagonal;
  }
}

}  // namespace

void repair_faces(InputFaces& faces, const BuildOptions& options, double tolerance) {
  sew(faces, tolerance);
  const Marks seen_from_both_sides = turn_outwards(faces);
  if (faces.topology.closed()) return;
  pair_straightest(faces.triangles, faces.points, faces.topology);
  const std::vector<BoundaryLoop> rims = find_rim_loops(faces.topology.opposite);
  faces.report.boundary_loops = static_cast<Index>(rims.size());
  if (options.largest_hole > 0) check_holes(rims, faces, options.largest_hole);
  const bool thickens = options.thicken_what == ThickenWhat::kSheets;
  if (options.winding_threshold == 0) {
    close_holes(faces, seen_from_both_sides, tolerance, thickens ? options.thicken : 0);
  }
  faces.repair = !faces.topology.closed();
  if (faces.repair) pair_straightest(faces.triangles, faces.points, faces.topology);
}

void turn_inverted_parts(InputFaces& faces) {
  Topology straightest;  // of parts that share edges
  if (!faces.topology.non_manifold_sides.empty()) {
    straightest = faces.topology;
    pair_straightest(faces.triangles, faces.points, straightest);
  }
  const InvertedParts inverted = find_inverted_parts(
      faces.triangles, faces.points, straightest.opposite.empty() ? faces.topology : straightest);
  faces.report.nesting_known = inverted.nesting_known;
  if (inverted.parts == 0) return;
  turn_faces(faces, inverted.must_turn);
  find_topology(faces);
  faces.report.flipped = inverted.all;
  if (inverted.all) return;
  faces.report.turned_parts = inverted.parts;
  faces.report.turned_faces += static_cast<Index>(inverted.must_turn.count());
}

}  // namespace kdm
