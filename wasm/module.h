// SPDX-License-Identifier: MIT
// The functions that the wrapper calls: marshal, call the library, marshal. Each returns what
// `guard` makes of it. A new option is one line in `to_build_options` or one of its neighbours.
#pragma once

#include <malloc.h>

#include <emscripten/heap.h>

#include "kdmanifold/kdmanifold.h"
#include "marshal.h"

namespace kdm::wasm {

inline constexpr std::array<Named<SplitStrategy>, 5> kStrategies = {
    {{"adaptive", SplitStrategy::kAdaptive},
     {"octree", SplitStrategy::kOctree},
     {"feature", SplitStrategy::kFeature},
     {"median", SplitStrategy::kMedian},
     {"uniform", SplitStrategy::kUniform}}};
inline constexpr std::array<Named<InsideRule>, 5> kInsideRules = {
    {{"repair", InsideRule::kRepair},
     {"positive", InsideRule::kPositive},
     {"odd", InsideRule::kOdd},
     {"nonzero", InsideRule::kNonzero},
     {"sheet", InsideRule::kSheet}}};
inline constexpr std::array<Named<Pairing>, 4> kPairings = {{{"trace", Pairing::kTrace},
                                                             {"hermite", Pairing::kHermite},
                                                             {"inside", Pairing::kInside},
                                                             {"outside", Pairing::kOutside}}};
inline constexpr std::array<Named<Parts>, 3> kParts = {
    {{"all", Parts::kAll}, {"outer", Parts::kOuter}, {"largest", Parts::kLargest}}};
inline constexpr std::array<Named<Strict>, 3> kStrict = {
    {{"off", Strict::kOff}, {"manifold", Strict::kManifold}, {"embedded", Strict::kEmbedded}}};
inline constexpr std::array<Named<VertexPosition>, 2> kPositions = {
    {{"constrained", VertexPosition::kConstrained}, {"projection", VertexPosition::kProjection}}};
inline constexpr std::array<Named<MeshFormat>, 4> kFormats = {{{"obj", MeshFormat::kObj},
                                                               {"stl", MeshFormat::kStl},
                                                               {"ply", MeshFormat::kPly},
                                                               {"off", MeshFormat::kOff}}};

inline BuildOptions to_build_options(const val& from) {
  BuildOptions options;
  read(from, "strategy", options.strategy, kStrategies);
  read(from, "tolerance", options.tolerance);
  read(from, "relativeTolerance", options.relative_tolerance);
  read(from, "depth", options.depth);
  read(from, "inside", options.inside, kInsideRules);
  read(from, "windingThreshold", options.winding_threshold);
  read(from, "largestHole", options.largest_hole);
  read(from, "pairing", options.pairing, kPairings);
  read(from, "thicken", options.thicken);
  return options;
}

inline ExtractOptions to_extract_options(const val& from) {
  ExtractOptions options;
  read(from, "quads", options.quads);
  read(from, "splitError", options.split_error);
  read(from, "position", options.position, kPositions);
  read(from, "unfold", options.unfold);
  read(from, "linkError", options.link_error);
  read(from, "strict", options.strict, kStrict);
  read(from, "parts", options.parts, kParts);
  read(from, "normals", options.normals);
  read(from, "creaseAngle", options.crease_angle);
  return options;
}

inline AnalyzeOptions to_analyze_options(const val& from) {
  AnalyzeOptions options;
  read(from, "selfIntersections", options.self_intersections);
  return options;
}

inline val from_box(const Box& box) {
  val to = val::object();
  to.set("min", copy_out("Float64Array", 3, box.min.data()));
  to.set("max", copy_out("Float64Array", 3, box.max.data()));
  return to;
}

inline val from_input_report(const InputReport& report) {
  val to = val::object();
  to.set("vertices", report.vertices);
  to.set("triangles", report.triangles);
  to.set("closed", report.closed);
  to.set("boundaryEdges", report.boundary_edges);
  to.set("boundaryLoops", report.boundary_loops);
  to.set("nonManifoldEdges", report.non_manifold_edges);
  to.set("degenerateFaces", report.degenerate_faces);
  to.set("cancelledFaces", report.cancelled_faces);
  to.set("duplicateFaces", report.duplicate_faces);
  to.set("sewnEdges", report.sewn_edges);
  to.set("turnedFaces", report.turned_faces);
  to.set("components", report.components);
  to.set("flipped", report.flipped);
  to.set("latticeStep", report.lattice_step);
  return to;
}

inline val from_grid_stats(const GridStats& stats) {
  val to = val::object();
  to.set("cells", stats.cells);
  to.set("leaves", stats.leaves);
  to.set("hits", stats.hits);
  to.set("depth", stats.depth);
  to.set("sheet", stats.sheet);
  to.set("bytes", stats.bytes);
  to.set("tolerance", stats.tolerance);
  to.set("windingThreshold", stats.winding_threshold);
  to.set("topologyResolved", stats.topology_resolved);
  to.set("unresolvedLeaves", stats.unresolved_leaves);
  to.set("ambiguousFaces", stats.ambiguous_faces);
  to.set("guessedFaces", stats.guessed_faces);
  to.set("inventedHits", stats.invented_hits);
  return to;
}

inline val from_mesh_report(const MeshReport& report) {
  val to = val::object();
  to.set("vertices", report.vertices);
  to.set("triangles", report.triangles);
  to.set("quads", report.quads);
  to.set("unreferencedVertices", report.unreferenced_vertices);
  to.set("boundaryEdges", report.boundary_edges);
  to.set("boundaryLoops", report.boundary_loops);
  to.set("nonManifoldEdges", report.non_manifold_edges);
  to.set("misorientedEdges", report.misoriented_edges);
  to.set("nonManifoldVertices", report.non_manifold_vertices);
  to.set("degenerateFaces", report.degenerate_faces);
  to.set("duplicateFaces", report.duplicate_faces);
  to.set("components", report.components);
  to.set("eulerCharacteristic", static_cast<double>(report.euler_characteristic));
  to.set("closed", report.closed);
  to.set("twoManifold", report.two_manifold);
  to.set("manifold", report.manifold);
  to.set("volume", report.volume);
  to.set("area", report.area);
  to.set("bounds", from_box(report.bounds));
  return to;
}

// Loops one after the other with the place where each ends, parts as one array a field: there may
// be hundreds of thousands, and the wrapper makes objects of them quicker than calls from here.
inline val from_defects(const MeshDefects& defects) {
  val to = val::object();
  to.set("report", from_mesh_report(defects.report));
  to.set("balanced", defects.balanced);
  to.set("boundaryEdges", from_indices(defects.boundary_edges));
  to.set("nonManifoldEdges", from_indices(defects.non_manifold_edges));
  to.set("misorientedEdges", from_indices(defects.misoriented_edges));
  to.set("nonManifoldVertices", from_indices(defects.non_manifold_vertices));
  to.set("degenerateFaces", from_indices(defects.degenerate_faces));
  to.set("zeroAreaFaces", from_indices(defects.zero_area_faces));
  to.set("duplicateFaces", from_indices(defects.duplicate_faces));
  to.set("flippedFaces", from_indices(defects.flipped_faces));
  to.set("selfIntersectingFaces", from_indices(defects.self_intersecting_faces));
  to.set("selfIntersections", static_cast<double>(defects.self_intersections));
  to.set("nestingKnown", defects.nesting_known);
  to.set("partOf", from_indices(defects.part_of));
  std::vector<Index> loop_vertices;
  std::vector<Index> loop_ends;
  for (const std::vector<Index>& loop : defects.boundary_loops) {
    loop_vertices.insert(loop_vertices.end(), loop.begin(), loop.end());
    loop_ends.push_back(static_cast<Index>(loop_vertices.size()));
  }
  to.set("loopVertices", from_indices(loop_vertices));
  to.set("loopEnds", from_indices(loop_ends));
  std::vector<std::array<Index, 8>> counts;
  std::vector<std::array<double, 2>> sizes;
  for (const MeshPart& part : defects.parts) {
    counts.push_back({part.first_face, part.faces, part.boundary_loops, part.genus, part.inside,
                      part.closed, part.cavity, part.inside_out});
    sizes.push_back({part.area, part.volume});
  }
  to.set("partCounts", from_indices(counts));
  to.set("partSizes",
         copy_out("Float64Array", 2 * sizes.size(), reinterpret_cast<const double*>(sizes.data())));
  return to;
}

inline val build_grid(val mesh, val options, val progress) {
  return guard([&] {
    return val(kdm::build_grid(to_mesh(mesh), to_build_options(options), to_progress(progress)));
  });
}

inline val load_grid(val bytes, std::string name) {
  return guard([&] {
    const std::string copy = to_bytes(bytes);
    return val(
        kdm::load_grid({reinterpret_cast<const std::uint8_t*>(copy.data()), copy.size()}, name));
  });
}

inline val save_grid(const Grid& grid) {
  return guard([&] {
    const std::vector<std::uint8_t> bytes = kdm::save_grid(grid);
    return copy_out("Uint8Array", bytes.size(), bytes.data());
  });
}

inline val extract(const Grid& grid, val options, val progress) {
  return guard([&] {
    const ExtractedMesh mesh =
        kdm::extract(grid, to_extract_options(options), to_progress(progress));
    val to = from_mesh(mesh, "Float32Array");
    val report = val::object();
    report.set("droppedPillows", mesh.report.dropped_pillows);
    report.set("insertedVertices", mesh.report.inserted_vertices);
    report.set("splitVertices", mesh.report.split_vertices);
    report.set("linkVertices", mesh.report.link_vertices);
    report.set("flippedEdges", mesh.report.flipped_edges);
    report.set("refinedHits", mesh.report.refined_hits);
    report.set("droppedParts", mesh.report.dropped_parts);
    report.set("droppedCrumbs", mesh.report.dropped_crumbs);
    report.set("inventedArea", mesh.report.invented_area);
    const std::optional<std::uint64_t>& crossings = mesh.report.crossings;
    report.set("crossings", crossings ? val(static_cast<double>(*crossings)) : val::null());
    report.set("boundaryLoops", mesh.report.boundary_loops);
    to.set("report", report);
    return to;
  });
}

inline val thicken(val mesh, double thickness) {
  return guard([&] { return from_mesh(kdm::thicken(to_mesh(mesh), thickness), "Float64Array"); });
}

inline val grid_stats(const Grid& grid) { return from_grid_stats(grid.stats()); }

inline val grid_input(const Grid& grid) { return from_input_report(grid.input()); }

// Positions stay 64-bit, as the native command line has them: both make the same grid.
inline val parse_mesh(val bytes, val format, std::string name) {
  return guard([&] {
    return from_mesh(kdm::parse_mesh(to_bytes(bytes), to_enum(format, "format", kFormats), name),
                     "Float64Array");
  });
}

inline val format_mesh(val mesh, val format, bool exact) {
  return guard([&] {
    return from_bytes(kdm::format_mesh(to_mesh(mesh), to_enum(format, "format", kFormats),
                                       exact ? Digits::kExact : Digits::kShortest));
  });
}

inline val find_self_intersections(val mesh) {
  return guard([&] {
    const SelfIntersections found = kdm::find_self_intersections(to_mesh(mesh));
    val to = val::object();
    to.set("pairs", static_cast<double>(found.pairs));
    to.set("faces", from_indices(found.faces));
    return to;
  });
}

inline val analyze(val mesh, val options) {
  return guard(
      [&] { return from_defects(kdm::analyze(to_mesh(mesh), to_analyze_options(options))); });
}

inline val describe(val mesh) {
  return guard([&] { return from_mesh_report(kdm::describe(to_mesh(mesh))); });
}

/// Bytes of the heap (it never shrinks, so: the most that was ever needed) and bytes in use.
inline val memory() {
  val to = val::object();
  to.set("heapBytes", emscripten_get_heap_size());
  to.set("usedBytes", static_cast<std::size_t>(mallinfo().uordblks));
  return to;
}

inline std::string version() { return KDM_VERSION; }

}  // namespace kdm::wasm
