// SPDX-License-Identifier: MIT
// Writes the report as text.
#include "cli/report_text.h"

#include <fmt/format.h>

namespace kdm::cli {
namespace {

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

std::string defects_text(const MeshDefects& defects) {
  const PartSums sums = sum_parts(defects);
  std::string text;
  const auto add = [&](std::uint64_t count, const char* what) {
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, what);
  };
  add(defects.boundary_edges.size(), "open edges");
  add(defects.boundary_loops.size(), "boundary loops");
  add(defects.non_manifold_edges.size(), "edges with three or more faces");
  add(defects.misoriented_edges.size(), "edges whose faces disagree");
  add(defects.non_manifold_vertices.size(), "vertices that are not manifold");
  add(defects.degenerate_faces.size(), "faces with a repeated vertex");
  add(defects.zero_area_faces.size(), "faces without area");
  add(defects.duplicate_faces.size(), "doubled faces");
  add(defects.flipped_faces.size(), "faces turned the wrong way");
  add(defects.self_intersections, "pairs of triangles cross");
  add(sums.inside_out, "parts inside out");
  const char* nesting = defects.nesting_known ? "" : " (too many overlap to look for them)";
  return fmt::format("defects  {}\nparts    {} open, {} closed, {} of these cavities{}, genus {}\n",
                     text.empty() ? "none" : text, sums.open, defects.parts.size() - sums.open,
                     sums.cavities, nesting, sums.genus);
}

std::string seconds_text(const RunReport& report, const Command& command) {
  std::string text = fmt::format("seconds  read {:.3f}", report.seconds.read);
  if (command.report.stats) text += fmt::format(", analyze {:.3f}", report.seconds.analyze);
  if (converts(command)) {
    text += fmt::format(", build {:.3f}", report.seconds.build);
    if (report.simplified) text += fmt::format(", simplify {:.3f}", report.seconds.simplify);
    text += fmt::format(", extract {:.3f}", report.seconds.extract);
    if (report.reduced) text += fmt::format(", reduce {:.3f}", report.seconds.reduce);
  }
  if (writes(command.files)) text += fmt::format(", write {:.3f}", report.seconds.write);
  return text + '\n';
}

std::string input_text(const RunReport& report, const Command& command, const Task& task) {
  const auto text = [&](std::size_t vertices, std::size_t triangles, std::size_t parts) {
    return fmt::format("input    {}: {} vertices, {} triangles, {} parts", input_name(task.input),
                       vertices, triangles, parts);
  };
  if (!converts(command)) {
    const MeshDefects& input = report.defects;
    return text(input.report.vertices, input.report.triangles, input.parts.size()) + '\n';
  }
  const InputReport& input = report.input;
  std::string lines = text(input.vertices, input.triangles, input.components);
  if (!report.operands.empty()) lines += fmt::format(", {} operands", report.operands.size());
  lines += input.flipped ? ", turned inside out\n" : "\n";
  if (input.degenerate_faces + input.cancelled_faces > 0) {
    lines += fmt::format("         {} faces without area and {} back to back take no part\n",
                         input.degenerate_faces, input.cancelled_faces);
  }
  return lines;
}

// What had to be done to surfaces that are not closed and consistently oriented.
std::string repair_text(const RunReport& report) {
  const InputReport& input = report.input;
  const bool cut = input.closed && report.grid.thin_area + report.grid.narrow_area > 0;
  if (input.sewn_edges + input.turned_faces + input.duplicate_faces == 0 &&
      (cut || report.grid.invented_hits == 0)) {
    return "";
  }
  const double area = report.output.area;
  std::string text = fmt::format(
      "repair   {} pairs of edges sewn, {} faces turned, {} doubled ones left out; {:.1f} % of the "
      "area closes holes, {} crumbs dropped\n",
      input.sewn_edges, input.turned_faces, input.duplicate_faces,
      area > 0 ? 100 * report.extracted.invented_area / area : 0, report.extracted.dropped_crumbs);
  if (report.grid.winding_threshold > 0) {
    text += fmt::format("         winding numbers above {} are inside\n",
                        report.grid.winding_threshold);
  }
  return text;
}

// Writes a number in full with three digits that count. In Node they get the same.
std::string three_digits(double value) {
  int decimals = 0;
  for (double scaled = value; scaled < 100 && decimals < 20; scaled *= 10) ++decimals;
  return fmt::format("{:.{}f}", value, value > 0 ? decimals : 0);
}

std::string error_text(const MeshError& error) {
  const auto numbers = [](const Deviation& d) {
    return fmt::format("at most {} (rms {})", three_digits(d.largest), three_digits(d.rms));
  };
  return fmt::format("result to input {}, input to result {}", numbers(error.to_input),
                     numbers(error.to_output));
}

// What the result lacks, and how far it is from the input.
std::string account_text(const RunReport& report) {
  std::string text;
  if (report.lost && report.lost->area > 0) {
    text += fmt::format("lost     {} % of the input's area, in {} pieces\n",
                        three_digits(100 * report.lost->share), report.lost->parts);
  }
  if (report.error) text += fmt::format("error    {}\n", error_text(*report.error));
  return text;
}

std::string reduction_text(const RunReport& report) {
  std::string text;
  if (report.simplified) {
    text += fmt::format("simpler  grid from {} cells to {}\n", report.simplified->cells_before,
                        report.simplified->cells);
    if (report.simplified->removed_surfaces > 0) {
      text += fmt::format("         {} thin parts removed, {} thin cavities filled\n",
                          report.simplified->removed_parts, report.simplified->filled_cavities);
    }
  }
  if (report.reduced) {
    text += fmt::format("reduced  from {} triangles to {}\n", report.reduced->triangles_before,
                        report.reduced->triangles);
  }
  for (const Level& level : report.levels) {
    text += fmt::format("level    {}{}{} triangles, {}\n", level.file,
                        level.file.empty() ? "" : ": ", level.triangles, error_text(level.error));
  }
  return text;
}

std::string result_text(const RunReport& report, const Command& command, const Task& task) {
  const GridStats& grid = report.grid;
  const MeshReport& output = report.output;
  std::string text =
      fmt::format("grid     {}, depth {}: {} cells, {} hits, {:.1f} MB{}\n",
                  task.is_grid ? "loaded" : word_of(command.build.strategy), grid.depth, grid.cells,
                  grid.hits, static_cast<double>(grid.bytes) / 1e6, topology_text(grid));
  std::string output_text = task.output == kStandardStream ? "standard output" : task.output;
  if (report.levels.size() > 1) output_text = report.levels.back().file;
  text += fmt::format("output   {}{}{} vertices, {}, {} parts, Euler characteristic {}, {}\n",
                      output_text, output_text.empty() ? "" : ": ", output.vertices,
                      faces_text(output.triangles, output.quads), output.components,
                      output.euler_characteristic, kind_text(output, report.extracted, grid.sheet));
  text += reduction_text(report);
  text += repair_text(report);
  text += account_text(report);
  if (command.report.check) text += check_text(output, report.self_intersections, grid.sheet);
  return text;
}

}  // namespace

std::string report_as_text(const RunReport& report, const Command& command, const Task& task) {
  std::string text;
  for (const Warning& warning : report.warnings) {
    text += fmt::format("warning  {}\n", warning.message);
  }
  text += input_text(report, command, task);
  if (command.report.stats) text += defects_text(report.defects);
  if (converts(command)) text += result_text(report, command, task);
  return text + seconds_text(report, command);
}

}  // namespace kdm::cli
