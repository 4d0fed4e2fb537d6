// SPDX-License-Identifier: MIT
// Writes the report. Keys are the C++ names in camel case; web/src/types.ts has the same.
#include "cli/report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace kdm::cli {
namespace {

using Json = nlohmann::ordered_json;

Json input_json(const InputReport& input) {
  return {{"vertices", input.vertices},
          {"triangles", input.triangles},
          {"closed", input.closed},
          {"boundaryEdges", input.boundary_edges},
          {"boundaryLoops", input.boundary_loops},
          {"nonManifoldEdges", input.non_manifold_edges},
          {"degenerateFaces", input.degenerate_faces},
          {"cancelledFaces", input.cancelled_faces},
          {"components", input.components},
          {"flipped", input.flipped},
          {"latticeStep", input.lattice_step}};
}

Json grid_json(const GridStats& grid) {
  return {{"cells", grid.cells},
          {"leaves", grid.leaves},
          {"hits", grid.hits},
          {"depth", grid.depth},
          {"bytes", grid.bytes},
          {"topologyResolved", grid.topology_resolved},
          {"unresolvedLeaves", grid.unresolved_leaves},
          {"ambiguousFaces", grid.ambiguous_faces},
          {"guessedFaces", grid.guessed_faces}};
}

Json output_json(const MeshReport& output, const ExtractReport& extracted) {
  return {{"vertices", output.vertices},
          {"triangles", output.triangles},
          {"quads", output.quads},
          {"components", output.components},
          {"eulerCharacteristic", output.euler_characteristic},
          {"twoManifold", output.two_manifold},
          {"manifold", output.manifold},
          {"closed", output.closed},
          {"boundaryLoops", extracted.boundary_loops},
          {"volume", output.volume},
          {"area", output.area},
          {"droppedPillows", extracted.dropped_pillows},
          {"insertedVertices", extracted.inserted_vertices},
          {"splitVertices", extracted.split_vertices},
          {"linkVertices", extracted.link_vertices},
          {"flippedEdges", extracted.flipped_edges},
          {"refinedHits", extracted.refined_hits},
          {"crossings", extracted.crossings ? Json(*extracted.crossings) : Json()}};
}

// What --check looked for.
Json check_json(const MeshReport& output) {
  return {{"twoManifold", output.two_manifold},
          {"manifold", output.manifold},
          {"closed", output.closed},
          {"boundaryEdges", output.boundary_edges},
          {"nonManifoldEdges", output.non_manifold_edges},
          {"misorientedEdges", output.misoriented_edges},
          {"nonManifoldVertices", output.non_manifold_vertices},
          {"degenerateFaces", output.degenerate_faces},
          {"duplicateFaces", output.duplicate_faces}};
}

std::string faces_text(std::uint64_t triangles, std::uint64_t quads) {
  return quads == 0 ? fmt::format("{} triangles", triangles)
                    : fmt::format("{} triangles and {} quads", triangles, quads);
}

std::string topology_text(const GridStats& grid) {
  if (grid.topology_resolved) return ", topology resolved";
  if (grid.unresolved_leaves == 0) return "";  // the other strategies do not look
  return fmt::format(", topology given up in {} leaves", grid.unresolved_leaves);
}

std::string kind_text(const MeshReport& output, const ExtractReport& extracted, bool sheet) {
  if (output.two_manifold) return "closed 2-manifold";
  if (!sheet || !output.manifold) return "not 2-manifold";
  return fmt::format("manifold with {} boundary loops", extracted.boundary_loops);
}

std::string check_text(const MeshReport& output, std::uint64_t self_intersections, bool sheet) {
  if (passes_check(output, sheet)) {
    return fmt::format("check    passed: 2-manifold{}; {} pairs of triangles cross\n",
                       output.two_manifold ? "" : " with boundary",
                       self_intersections == 0 ? "no" : std::to_string(self_intersections));
  }
  return fmt::format(
      "check    FAILED: {} boundary, {} non-manifold, {} misoriented edges, {} non-manifold "
      "vertices, {} degenerate, {} duplicate faces\n",
      output.boundary_edges, output.non_manifold_edges, output.misoriented_edges,
      output.non_manifold_vertices, output.degenerate_faces, output.duplicate_faces);
}

bool writes(const Command& command) {
  return !command.output.empty() || !command.save_grid.empty();
}

}  // namespace

bool passes_check(const MeshReport& output, bool sheet) {
  return sheet ? output.manifold : output.two_manifold;
}

std::string report_as_json(const RunReport& report, const Command& command) {
  Json json = {{"input", input_json(report.input)},
               {"grid", grid_json(report.grid)},
               {"output", output_json(report.output, report.extracted)}};
  if (command.check) {
    json["output"]["selfIntersections"] = report.self_intersections;
    json["check"] = check_json(report.output);
  }
  json["seconds"] = {{"read", report.seconds.read},
                     {"build", report.seconds.build},
                     {"extract", report.seconds.extract}};
  if (writes(command)) json["seconds"]["write"] = report.seconds.write;
  json["peakBytes"] = report.peak_bytes;
  return json.dump(2) + "\n";
}

std::string report_as_text(const RunReport& report, const Command& command) {
  const InputReport& input = report.input;
  const GridStats& grid = report.grid;
  const MeshReport& output = report.output;
  const bool sheet = command.build.inside == InsideRule::kSheet;
  std::string text = fmt::format("input    {}: {} vertices, {} triangles, {} parts{}\n",
                                 command.input, input.vertices, input.triangles, input.components,
                                 input.flipped ? ", turned inside out" : "");
  if (input.degenerate_faces + input.cancelled_faces > 0) {
    text += fmt::format("         {} faces without area and {} back to back take no part\n",
                        input.degenerate_faces, input.cancelled_faces);
  }
  text += fmt::format("grid     {}, depth {}: {} cells, {} hits, {:.1f} MB{}\n",
                      names_a_grid(command.input) ? "loaded" : word_of(command.build.strategy),
                      grid.depth, grid.cells, grid.hits, static_cast<double>(grid.bytes) / 1e6,
                      topology_text(grid));
  text += fmt::format("output   {}{}{} vertices, {}, {} parts, Euler characteristic {}, {}\n",
                      command.output, command.output.empty() ? "" : ": ", output.vertices,
                      faces_text(output.triangles, output.quads), output.components,
                      output.euler_characteristic, kind_text(output, report.extracted, sheet));
  if (command.check) text += check_text(output, report.self_intersections, sheet);
  text += fmt::format("seconds  read {:.3f}, build {:.3f}, extract {:.3f}", report.seconds.read,
                      report.seconds.build, report.seconds.extract);
  if (writes(command)) text += fmt::format(", write {:.3f}", report.seconds.write);
  text += '\n';
  return text;
}

}  // namespace kdm::cli
