// SPDX-License-Identifier: MIT
// Writes the report as JSON. Keys are the members' names in camel case.
#include "cli/report_json.h"

namespace kdm::cli {
namespace {

template <typename Report>
Json all_fields(const Report& report) {
  Json json;
  add_fields(json, report);
  return json;
}

// The keys of `InputReport` that need no grid.
Json input_json(const MeshDefects& input) {
  return {{"vertices", input.report.vertices},
          {"triangles", input.report.triangles},
          {"closed", input.balanced},
          {"boundaryEdges", input.boundary_edges.size()},
          {"nonManifoldEdges", input.non_manifold_edges.size()},
          {"degenerateFaces", input.degenerate_faces.size() + input.zero_area_faces.size()},
          {"components", input.parts.size()}};
}

Json levels_json(const std::vector<Level>& levels) {
  Json json = Json::array();
  for (const Level& level : levels) {
    json.push_back({{"triangles", level.triangles},
                    {"file", level.file.empty() ? Json() : Json(level.file)},
                    {"error", all_fields(level.error)}});
  }
  return json;
}

Json warnings_json(const std::vector<Warning>& warnings) {
  Json json = Json::array();
  for (const Warning& warning : warnings) {
    json.push_back({{"code", warning.code}, {"message", warning.message}});
  }
  return json;
}

Json seconds_json(const RunReport& report, const Command& command) {
  Json json = {{"read", report.seconds.read}};
  if (command.report.stats) json["analyze"] = report.seconds.analyze;
  if (converts(command)) {
    json["build"] = report.seconds.build;
    if (report.simplified) json["simplify"] = report.seconds.simplify;
    json["extract"] = report.seconds.extract;
    if (report.reduced) json["reduce"] = report.seconds.reduce;
  }
  if (writes(command.files)) json["write"] = report.seconds.write;
  return json;
}

}  // namespace

Json output_json(const MeshReport& output, const ExtractReport& extracted) {
  Json json;
  add_fields(json, output,
             {"vertices", "triangles", "quads", "components", "euler_characteristic",
              "two_manifold", "manifold", "closed"});
  add_fields(json, extracted, {"boundary_loops"});
  add_fields(json, output, {"volume", "area"});
  add_fields(json, extracted);
  return json;
}

Json check_json(const MeshReport& output) {
  Json json;
  add_fields(json, output,
             {"two_manifold", "manifold", "closed", "boundary_edges", "non_manifold_edges",
              "misoriented_edges", "non_manifold_vertices", "degenerate_faces", "duplicate_faces"});
  return json;
}

Json defects_json(const MeshDefects& defects) {
  Json json;
  add_fields(json, defects,
             {"boundary_edges", "boundary_loops", "non_manifold_edges", "misoriented_edges",
              "non_manifold_vertices", "degenerate_faces", "zero_area_faces", "duplicate_faces",
              "flipped_faces", "self_intersections", "self_intersecting_faces"});
  const PartSums sums = sum_parts(defects);
  json["openParts"] = sums.open;
  json["insideOutParts"] = sums.inside_out;
  json["cavities"] = sums.cavities;
  json["genus"] = sums.genus;
  json["area"] = sums.area;
  json["volume"] = sums.volume;
  add_fields(json, defects, {"nesting_known"});
  return json;
}

Json report_as_json(const RunReport& report, const Command& command) {
  Json json;
  json["input"] = converts(command) ? all_fields(report.input) : input_json(report.defects);
  if (command.report.stats) json["defects"] = defects_json(report.defects);
  for (const InputReport& operand : report.operands) {
    json["operands"].push_back(all_fields(operand));
  }
  if (converts(command)) {
    json["grid"] = all_fields(report.grid);
    json["output"] = output_json(report.output, report.extracted);
    if (report.simplified) json["simplify"] = all_fields(*report.simplified);
    if (report.reduced) json["reduce"] = all_fields(*report.reduced);
    if (!report.levels.empty()) json["levels"] = levels_json(report.levels);
    if (report.lost) json["lost"] = all_fields(*report.lost);
    if (report.error) json["error"] = all_fields(*report.error);
  }
  json["warnings"] = warnings_json(report.warnings);
  if (command.report.check) {
    json["output"]["selfIntersections"] = report.self_intersections;
    json["check"] = check_json(report.output);
  }
  json["seconds"] = seconds_json(report, command);
  json["peakBytes"] = report.peak_bytes;
  return json;
}

}  // namespace kdm::cli
