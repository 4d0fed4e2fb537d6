// SPDX-License-Identifier: MIT
// The one table of what reports hold: names, units, meaning. The JSON of the command lines and the
// JavaScript package with its types are made from it. A new value is a member of its struct, and an
// entry here.
#pragma once

#include <concepts>
#include <type_traits>

#include "kdmanifold/account.h"
#include "kdmanifold/analyze.h"
#include "kdmanifold/extract.h"
#include "kdmanifold/field.h"
#include "kdmanifold/grid.h"
#include "kdmanifold/mesh.h"
#include "kdmanifold/reduce.h"
#include "kdmanifold/simplify.h"

namespace kdm {

/// A number that may be missing (kNone), as `for_each_field` hands it out: null in JavaScript.
struct OrNone {
  Index number;
};

/// Calls `visit(const ReportField&, member)` for every value, in the order in which reports list
/// them; members are const if the report is.
template <typename Report, typename Visit>
requires std::same_as<std::remove_const_t<Report>, InputReport>
void for_each_field(Report& report, Visit&& visit) {
  visit(ReportField{"vertices", "After joining vertices of exactly equal position"},
        report.vertices);
  visit(ReportField{"triangles", "Triangles of the input"}, report.triangles);
  visit(ReportField{"closed", "Every edge is used equally often in both directions"},
        report.closed);
  visit(ReportField{"boundary_edges", "Edges with one face"}, report.boundary_edges);
  visit(ReportField{"boundary_loops",
                    "Closed rounds of the edges at which the surface ends: those with one face, "
                    "and faces without a neighbour that runs against them along the edge. "
                    "`repair`: once the surface is sewn and turned"},
        report.boundary_loops);
  visit(ReportField{"non_manifold_edges", "Edges with three or more faces"},
        report.non_manifold_edges);
  visit(ReportField{"degenerate_faces",
                    "Faces without area once positions are rounded; they take no part"},
        report.degenerate_faces);
  visit(ReportField{"cancelled_faces", "Faces that lie back to back in pairs; they take no part"},
        report.cancelled_faces);
  visit(ReportField{"duplicate_faces",
                    "`repair`, `odd`: faces over the same corners as others; they take no part"},
        report.duplicate_faces);
  visit(ReportField{"sewn_edges",
                    "`repair`: pairs of boundary edges, no further apart than the tolerance, that "
                    "were joined"},
        report.sewn_edges);
  visit(ReportField{"turned_faces",
                    "`repair`: faces that were turned to agree with their neighbours and look "
                    "outwards"},
        report.turned_faces);
  visit(ReportField{"turned_parts",
                    "`repair`: closed parts that were inside out and have been turned, their faces "
                    "counting as turned too. Cavities are none. 0 if the whole input was inside "
                    "out (`flipped`)"},
        report.turned_parts);
  visit(ReportField{"nesting_known",
                    "`repair`: false if so many closed parts overlap that nobody has looked which "
                    "lie in which; then none was turned by itself"},
        report.nesting_known);
  visit(ReportField{"components", "Parts joined by edges"}, report.components);
  visit(ReportField{"patched_holes",
                    "`repair`: holes that were closed by patches over their corners"},
        report.patched_holes);
  visit(ReportField{"patch_area", "`repair`: area of these patches", Unit::kModelArea},
        report.patch_area);
  visit(ReportField{"lost_parts", "`repair`: parts that were left out because they bound nothing"},
        report.lost_parts);
  visit(ReportField{"lost_area", "`repair`: area of these parts", Unit::kModelArea},
        report.lost_area);
  visit(ReportField{"largest_lost", "`repair`: area of the largest of them", Unit::kModelArea},
        report.largest_lost);
  visit(ReportField{"thickened_parts",
                    "`repair`: parts that bound nothing and were given a thickness"},
        report.thickened_parts);
  visit(ReportField{"rebuilt_parts",
                    "Parts that were built by themselves. `repair`: those that neither sewing nor "
                    "patches close, beside others that are closed. `repair`, `positive`: thin "
                    "parts that cross or touch each other, which their union replaces"},
        report.rebuilt_parts);
  visit(ReportField{"rebuilding_tolerance", "What the tolerance was for these parts, at most",
                    Unit::kModelUnits},
        report.rebuilding_tolerance);
  visit(ReportField{"sewing_distance",
                    "`repair`: distance up to which boundary edges were joined: the tolerance, or "
                    "more where most of them lie further from their partners; 0 if none was joined",
                    Unit::kModelUnits},
        report.sewing_distance);
  visit(ReportField{"stray_parts",
                    "Parts that hold next to no area and lie far from the rest; `extent` leaves "
                    "them out"},
        report.stray_parts);
  visit(ReportField{"extent",
                    "The length that a relative tolerance is a fraction of: the diagonal of the "
                    "bounding box, without stray parts",
                    Unit::kModelUnits},
        report.extent);
  visit(ReportField{"flipped", "The input was inside out and has been turned"}, report.flipped);
  visit(ReportField{"lattice_step", "The step to which positions were rounded for decisions",
                    Unit::kModelUnits},
        report.lattice_step);
}

/// See `for_each_field` of `InputReport`.
template <typename Visit>
void for_each_field(const GridStats& stats, Visit&& visit) {
  visit(ReportField{"cells", "Nodes of the kd-tree"}, stats.cells);
  visit(ReportField{"leaves", "Cells that are not split"}, stats.leaves);
  visit(ReportField{"hits", "Intersections of the surface with grid edges"}, stats.hits);
  visit(ReportField{"depth", "Depth of the deepest leaf"}, stats.depth);
  visit(ReportField{"sheet", "The grid was built as a `sheet`: results may have a boundary"},
        stats.sheet);
  visit(ReportField{"bytes", "Memory that the grid holds", Unit::kBytes}, stats.bytes);
  visit(ReportField{"asked_tolerance", "The tolerance that was asked for; 0: none",
                    Unit::kModelUnits},
        stats.asked_tolerance);
  visit(ReportField{"tolerance",
                    "How far the result may be from the input: the tolerance that was asked for, "
                    "or a wider one where a surface to be repaired would have taken beyond all "
                    "measure. For strategies without a tolerance: the one that extraction goes "
                    "by. Of a grid by itself that was built for a reduced result: 0.8 times it",
                    Unit::kModelUnits},
        stats.tolerance);
  visit(ReportField{"simplified",
                    "How far the surface may have moved as the grid was simplified, which comes on "
                    "top of the tolerance; 0: it was not",
                    Unit::kModelUnits},
        stats.simplified);
  visit(ReportField{"winding_threshold",
                    "`repair`: winding numbers above this are inside; 0 where the surface is "
                    "closed and none had to be asked for"},
        stats.winding_threshold);
  visit(ReportField{"topology_resolved",
                    "`adaptive`, `octree`, `feature`: no leaf was given up and no face was "
                    "guessed; the result of an embedded input then has its topology. The other "
                    "strategies do not look: false"},
        stats.topology_resolved);
  visit(ReportField{"unresolved_leaves",
                    "Leaves given up at the depth limit or below the least size of a cell"},
        stats.unresolved_leaves);
  visit(ReportField{"unresolved_positions",
                    "Centres of these leaves, three coordinates each: of all, or, of more than "
                    "1,000, of every second, fourth and so on. Saved grids do not keep them",
                    Unit::kModelUnits},
        stats.unresolved_positions);
  visit(ReportField{"exact_parts",
                    "`adaptive`, `octree`, `feature`: parts about as thin as the tolerance that "
                    "meet no others; they are taken over just as they are in the input, or as they "
                    "were rebuilt"},
        stats.exact_parts);
  visit(ReportField{"exact_triangles", "Triangles of these parts"}, stats.exact_triangles);
  visit(ReportField{"thin_parts", "Further thin parts, whose thickness may differ in the result"},
        stats.thin_parts);
  visit(ReportField{"ambiguous_faces", "Faces between leaves with more than two hits"},
        stats.ambiguous_faces);
  visit(ReportField{"guessed_faces", "Ambiguous faces that a trace of the input could not decide"},
        stats.guessed_faces);
  visit(ReportField{"invented_hits", "Hits of no input face, where holes were closed"},
        stats.invented_hits);
  visit(ReportField{"thin_area",
                    "Area of the surface that is thinner than `minimum_thickness`, and gone",
                    Unit::kModelArea},
        stats.thin_area);
  visit(ReportField{"narrow_area",
                    "Area of the surface that bounds gaps narrower than `minimum_gap`, which are "
                    "filled",
                    Unit::kModelArea},
        stats.narrow_area);
}

/// See `for_each_field` of `InputReport`.
template <typename Visit>
void for_each_field(const ExtractReport& report, Visit&& visit) {
  visit(ReportField{"boundary_loops", "Closed walks along the boundary; only sheets have one"},
        report.boundary_loops);
  visit(ReportField{"dropped_pillows", "Parts without volume that were left out"},
        report.dropped_pillows);
  visit(ReportField{"inserted_vertices", "Vertices added to keep edges apart"},
        report.inserted_vertices);
  visit(ReportField{"split_vertices", "Vertices added for further features of a cell"},
        report.split_vertices);
  visit(ReportField{"link_vertices", "Vertices added between cells and at hits"},
        report.link_vertices);
  visit(ReportField{"flipped_edges", "Edges flipped, of triangles that were folded over or thin"},
        report.flipped_edges);
  visit(ReportField{"refined_hits", "`embedded`: hits that got vertices so that nothing crosses"},
        report.refined_hits);
  visit(ReportField{"dropped_parts", "Parts left out because of the option `parts`"},
        report.dropped_parts);
  visit(ReportField{"small_parts", "Parts left out because of `drop_parts`, with what lay in them"},
        report.small_parts);
  visit(ReportField{"small_parts_volume", "Volume taken away with them", Unit::kModelVolume},
        report.small_parts_volume);
  visit(ReportField{"small_cavities",
                    "Cavities filled because of `drop_cavities`, with what lay in them"},
        report.small_cavities);
  visit(ReportField{"small_cavities_volume", "Volume filled with them", Unit::kModelVolume},
        report.small_cavities_volume);
  visit(ReportField{"small_handles", "Handles removed because of `drop_handles`"},
        report.small_handles);
  visit(
      ReportField{"kept_handles",
                  "Handles smaller than `drop_handles` that are still there, since nothing closes "
                  "them without meeting the surface"},
      report.kept_handles);
  visit(ReportField{"dropped_crumbs", "Slivers beside closed holes that were left out"},
        report.dropped_crumbs);
  visit(ReportField{"invented_area",
                    "Area of the faces that stand for no input face but close a hole; their source "
                    "face is 4294967295",
                    Unit::kModelArea},
        report.invented_area);
  visit(ReportField{"crossings",
                    "`embedded`: pairs of triangles that still cross or touch, and triangles "
                    "without area; 0 unless parts of "
                    "the surface nearer to each other than 32 bits tell apart are in each other's "
                    "way, or sheets cross. Otherwise null: nobody has looked"},
        report.crossings);
}

/// See `for_each_field` of `InputReport`.
template <typename Visit>
void for_each_field(const LostArea& lost, Visit&& visit) {
  visit(
      ReportField{"area", "Area of the input that the result does not come near", Unit::kModelArea},
      lost.area);
  visit(ReportField{"parts", "Pieces of it, joined by vertices"}, lost.parts);
  visit(ReportField{"largest", "Area of the largest piece", Unit::kModelArea}, lost.largest);
  visit(ReportField{"share", "`area` as a fraction of the input's whole area"}, lost.share);
  visit(ReportField{"inner_area",
                    "Not in `area`: what lies within the solid, so that the inside rule drops it. "
                    "Where the input is closed, only walls with solid on both sides",
                    Unit::kModelArea},
        lost.inner_area);
  visit(ReportField{"faces", "The input's triangles that are lost, in whole or part"}, lost.faces);
}

/// See `for_each_field` of `InputReport`.
template <typename Visit>
void for_each_field(const Deviation& deviation, Visit&& visit) {
  visit(ReportField{"largest", "Of all vertices and points that were looked at", Unit::kModelUnits},
        deviation.largest);
  visit(ReportField{"rms", "Root of the mean square over the area", Unit::kModelUnits},
        deviation.rms);
}

/// See `for_each_field` of `InputReport`.
template <typename Visit>
void for_each_field(const MeshError& error, Visit&& visit) {
  visit(ReportField{"to_input",
                    "How far the result's points are from the input; those of what closes holes "
                    "count too"},
        error.to_input);
  visit(ReportField{"to_output",
                    "How far the input's points are from the result, without what lies within the "
                    "solid, more than a tolerance deep"},
        error.to_output);
}

/// See `for_each_field` of `InputReport`.
template <typename Visit>
void for_each_field(const ReduceReport& report, Visit&& visit) {
  visit(ReportField{"triangles_before", "Triangles of the mesh that was reduced"},
        report.triangles_before);
  visit(ReportField{"triangles", "Triangles that are left, of the last level"}, report.triangles);
  visit(ReportField{"collapses", "Edges that were collapsed"}, report.collapses);
  visit(
      ReportField{"flips", "Edges that were flipped, at creases that the reference does not have"},
      report.flips);
}

/// See `for_each_field` of `InputReport`.
template <typename Visit>
void for_each_field(const SimplifyReport& report, Visit&& visit) {
  visit(ReportField{"removed_splits", "Splits that were removed from the grid"},
        report.removed_splits);
  visit(ReportField{"cells_before", "Nodes of the kd-tree before"}, report.cells_before);
  visit(ReportField{"cells", "Nodes that are left"}, report.cells);
  visit(ReportField{"hits_before", "Intersections of the surface with grid edges before"},
        report.hits_before);
  visit(ReportField{"hits", "Intersections that are left"}, report.hits);
  visit(ReportField{"plane_error",
                    "The largest root mean square distance of merged hits from the plane that fits "
                    "them best (the paper's on-metric)",
                    Unit::kModelUnits},
        report.plane_error);
  visit(ReportField{"allowed_error",
                    "How far the surface may now be from what it was when the grid was built: what "
                    "all calls have been allowed",
                    Unit::kModelUnits},
        report.allowed_error);
  visit(ReportField{"removed_parts", "Thin bodies that went, each with the cavities in it"},
        report.removed_parts);
  visit(ReportField{"filled_cavities", "Thin cavities that were filled"}, report.filled_cavities);
  visit(ReportField{"removed_surfaces", "Closed surfaces that bounded these bodies and cavities"},
        report.removed_surfaces);
  visit(ReportField{"removed_handles", "Handles that these surfaces had"}, report.removed_handles);
}

/// See `for_each_field` of `InputReport`.
template <typename Visit>
void for_each_field(const MeshReport& report, Visit&& visit) {
  visit(ReportField{"vertices", "Positions, also those that no face uses"}, report.vertices);
  visit(ReportField{"triangles", "Faces with three corners"}, report.triangles);
  visit(ReportField{"quads", "Faces with four corners"}, report.quads);
  visit(ReportField{"unreferenced_vertices", "Positions that no face uses"},
        report.unreferenced_vertices);
  visit(ReportField{"boundary_edges", "Edges with one face"}, report.boundary_edges);
  visit(ReportField{"boundary_loops",
                    "Closed rounds of boundary edges; those that touch in a vertex count apart"},
        report.boundary_loops);
  visit(ReportField{"non_manifold_edges", "Edges with three or more faces"},
        report.non_manifold_edges);
  visit(ReportField{"misoriented_edges", "Edges whose two faces run the same way along them"},
        report.misoriented_edges);
  visit(ReportField{"non_manifold_vertices",
                    "Vertices whose faces do not form one fan; the ends of non-manifold edges are "
                    "among them"},
        report.non_manifold_vertices);
  visit(ReportField{"degenerate_faces", "Faces with a repeated vertex"}, report.degenerate_faces);
  visit(ReportField{"duplicate_faces", "Faces over the same vertices as an earlier one"},
        report.duplicate_faces);
  visit(ReportField{"components", "Parts joined by edges"}, report.components);
  visit(ReportField{"euler_characteristic",
                    "Referenced vertices - edges + faces: 2 for a sphere, less 2 for every handle"},
        report.euler_characteristic);
  visit(ReportField{"closed", "There is no edge with one face, and at least one face"},
        report.closed);
  visit(ReportField{"two_manifold",
                    "Closed, and every edge and every vertex is that of a surface, consistently "
                    "oriented; no face is degenerate or double"},
        report.two_manifold);
  visit(ReportField{"manifold", "The same, but there may be a boundary, as sheets have"},
        report.manifold);
  visit(ReportField{"volume",
                    "Signed, positive where normals point outwards; means nothing unless the mesh "
                    "is closed and oriented",
                    Unit::kModelVolume},
        report.volume);
  visit(ReportField{"area", "A quad counts as its two triangles at the corners 0 and 2",
                    Unit::kModelArea},
        report.area);
  visit(ReportField{"bounds", "Bounding box of the referenced vertices", Unit::kModelUnits},
        report.bounds);
}

/// See `for_each_field` of `InputReport`.
template <typename Visit>
void for_each_field(const SelfIntersections& found, Visit&& visit) {
  visit(ReportField{"pairs",
                    "Pairs of triangles; a quad counts as its two triangles at the corners 0 and "
                    "2"},
        found.pairs);
  visit(ReportField{"faces",
                    "The faces that are part of a pair, ascending: triangles first, then quads"},
        found.faces);
}

/// See `for_each_field` of `InputReport`. `genus` and `inside` may be kNone.
template <typename Visit>
void for_each_field(const MeshPart& part, Visit&& visit) {
  visit(ReportField{"first_face", "The lowest of its faces"}, part.first_face);
  visit(ReportField{"faces", "Number of its faces"}, part.faces);
  visit(ReportField{"boundary_loops", "Closed rounds of boundary edges"}, part.boundary_loops);
  visit(ReportField{"closed",
                    "Every edge is used equally often in both directions: the part bounds "
                    "something"},
        part.closed);
  visit(ReportField{"genus",
                    "Handles; null where the part is no oriented surface, because it has "
                    "misoriented edges or edges with three or more faces. Boundary loops count as "
                    "if each were closed by a disk"},
        OrNone{part.genus});
  visit(ReportField{"area", "Area of its faces", Unit::kModelArea}, part.area);
  visit(ReportField{"volume",
                    "Signed, positive where normals point outwards; 0 for parts that are not "
                    "closed",
                    Unit::kModelVolume},
        part.volume);
  visit(ReportField{"inside",
                    "The smallest (its number in `parts`) of the closed parts that hold this "
                    "closed part; null if there is none. Parts that cross each other do not hold "
                    "one another"},
        OrNone{part.inside});
  visit(ReportField{"cavity", "Turned inwards within parts that are turned outwards: a hollow"},
        part.cavity);
  visit(ReportField{"inside_out",
                    "Turned inwards without being a cavity, or within parts that are turned "
                    "inwards themselves"},
        part.inside_out);
}

/// See `for_each_field` of `InputReport`. Lists are visited as they are.
template <typename Visit>
void for_each_field(const MeshDefects& defects, Visit&& visit) {
  visit(ReportField{"report",
                    "What `describe` says once vertices of equal position are joined: the counts"},
        defects.report);
  visit(ReportField{"balanced",
                    "There are faces, and every edge is used equally often in both directions. Of "
                    "other meshes `build_grid` makes a solid by `repair` only"},
        defects.balanced);
  visit(ReportField{"boundary_edges",
                    "Edges with one face, two vertices each, in the order in which the face has "
                    "them"},
        defects.boundary_edges);
  visit(ReportField{"boundary_loops",
                    "The vertices of each closed round of boundary edges, in the direction of the "
                    "faces where these agree. Boundary edges that form none (they end on "
                    "non-manifold edges) are left out"},
        defects.boundary_loops);
  visit(ReportField{"non_manifold_edges",
                    "Edges with three or more faces, two vertices each, the lower one first"},
        defects.non_manifold_edges);
  visit(ReportField{"misoriented_edges",
                    "Edges whose two faces run the same way along them, two vertices each, the "
                    "lower one first"},
        defects.misoriented_edges);
  visit(ReportField{"non_manifold_vertices", "Vertices whose faces do not form one fan"},
        defects.non_manifold_vertices);
  visit(ReportField{"degenerate_faces", "Faces with a repeated vertex"}, defects.degenerate_faces);
  visit(ReportField{"zero_area_faces", "Faces of different vertices that lie exactly on one line"},
        defects.zero_area_faces);
  visit(ReportField{"duplicate_faces", "Faces over the same vertices as a face before"},
        defects.duplicate_faces);
  visit(ReportField{"flipped_faces",
                    "Faces turned against their neighbours, or with their whole part inwards, as "
                    "far as volume and what can be seen from outside tell: those that the inside "
                    "rule `repair` turns"},
        defects.flipped_faces);
  visit(ReportField{"self_intersections",
                    "Only if asked for: pairs of triangles that cross, touch or lie on each other "
                    "in that way; a quad counts as its two triangles at the corners 0 and 2"},
        defects.self_intersections);
  visit(ReportField{"self_intersecting_faces",
                    "Only if asked for: faces that cross or touch others where they share no "
                    "vertex or edge, and faces that lie on each other"},
        defects.self_intersecting_faces);
  visit(ReportField{"part_of",
                    "One entry a face: its number in `parts`; 4294967295 for degenerate faces"},
        defects.part_of);
  visit(ReportField{"parts", "The parts, in order of their first faces"}, defects.parts);
  visit(ReportField{"nesting_known",
                    "False: thousands of closed parts overlap, so that nobody has looked which lie "
                    "in which; `inside` is then null, `cavity` and `inside_out` false for all"},
        defects.nesting_known);
}

}  // namespace kdm
