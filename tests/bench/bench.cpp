// SPDX-License-Identifier: MIT
// The native benchmark: a table of seconds by stage, and the same as JSON.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "runner.h"

namespace {

using namespace kdm;
using namespace kdm::bench;
using nlohmann::json;

struct Setting {
  BuildOptions build;
  std::string text;
};

// "median:19", or with a relative tolerance "octree:21:0"
Setting parse_setting(const std::string& text) {
  Setting setting{{}, text};
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) {
    throw Error(ErrorCode::kInvalidOption, "setting '" + text + "' must look like median:19");
  }
  setting.build.strategy = strategy_from_name(text.substr(0, colon));
  std::size_t read = 0;
  setting.build.depth = std::stoi(text.substr(colon + 1), &read);
  const std::size_t second = colon + 1 + read;
  if (second < text.size()) {
    setting.build.relative_tolerance = std::stod(text.substr(second + 1));
  }
  return setting;
}

json to_json(const Model& model, const Setting& setting, const Run& run) {
  return {{"model", model.name},
          {"engine", "native"},
          {"strategy", strategy_name(setting.build.strategy)},
          {"depth", setting.build.depth},
          {"relativeTolerance", setting.build.relative_tolerance},
          {"input",
           {{"triangles", run.input.triangles},
            {"vertices", run.input.vertices},
            {"latticeStep", run.input.lattice_step}}},
          {"grid",
           {{"cells", run.grid.cells},
            {"hits", run.grid.hits},
            {"depth", run.grid.depth},
            {"bytes", run.grid.bytes},
            {"topologyResolved", run.grid.topology_resolved},
            {"unresolvedLeaves", run.grid.unresolved_leaves},
            {"ambiguousFaces", run.grid.ambiguous_faces},
            {"guessedFaces", run.grid.guessed_faces}}},
          {"output",
           {{"triangles", run.output.triangles.size()},
            {"vertices", run.output.positions.size()},
            {"droppedPillows", run.output.report.dropped_pillows},
            {"insertedVertices", run.output.report.inserted_vertices}}},
          {"clock", "processor"},
          {"seconds", run.seconds},
          {"peakBytes", run.peak_bytes}};
}

double stage(const Run& run, const char* name) {
  const auto found = run.seconds.find(name);
  return found == run.seconds.end() ? 0 : found->second;
}

// "build" holds prepare, construction; "topology" link and everything of extract but vertices.
void print_row(const Model& model, const Setting& setting, const Run& run) {
  const double build = stage(run, "prepare") + stage(run, "build");
  const double vertices = stage(run, "vertices");
  const double topology = stage(run, "total") - stage(run, "read") - build - vertices;
  std::printf("%-24s %-18s %8u %8zu %7.3f %7.3f %8.3f %8.3f %7.3f %6.2f %6.2f %6.0f\n",
              model.name.c_str(), setting.text.c_str(), run.input.triangles,
              run.output.triangles.size(), stage(run, "read"), build, topology, vertices,
              stage(run, "total"), run.input.triangles / build / 1e6,
              static_cast<double>(run.output.triangles.size()) / (topology + vertices) / 1e6,
              static_cast<double>(run.peak_bytes) / 1e6);
  std::fflush(stdout);
}

struct Command {
  std::vector<std::string> paths;
  std::vector<std::string> settings = {"adaptive:60", "median:19", "octree:21", "uniform:21"};
  int repeat = 5;
  int subdivide = 0;
  std::string json_path;
  std::string export_folder;
  std::string keep;
};

std::vector<Model> models_of(const Command& command) {
  std::vector<Model> models = load_models(command.paths);
  for (Model& model : models) {
    if (command.subdivide > 0) model = subdivided_model(model, command.subdivide);
  }
  return models;
}

int run(const Command& command) {
  json rows = json::array();
  std::printf("%-24s %-18s %8s %8s %7s %7s %8s %8s %7s %6s %6s %6s\n", "model", "rule", "in", "out",
              "read", "build", "topology", "vertices", "total", "Min/s", "Mout/s", "peakMB");
  for (const Model& model : models_of(command)) {
    for (const std::string& text : command.settings) {
      const Setting setting = parse_setting(text);
      try {
        const Run result = run_median(model, setting.build, command.repeat);
        print_row(model, setting, result);
        rows.push_back(to_json(model, setting, result));
        if (!command.keep.empty()) write_mesh(command.keep, result.output);
      } catch (const Error& error) {
        std::printf("%-24s %-18s %s\n", model.name.c_str(), text.c_str(),
                    error_code_name(error.code()));
        rows.push_back({{"model", model.name}, {"error", error_code_name(error.code())}});
        break;
      }
    }
  }
  if (!command.json_path.empty()) std::ofstream(command.json_path) << rows.dump(1) << '\n';
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Times the stages of mesh -> grid -> mesh: medians, in seconds.");
  Command command;
  app.add_option("--models,models", command.paths,
                 "files, folders or scene:NAME; default: generated scenes");
  app.add_option("--settings", command.settings,
                 "rule:depth or rule:depth:relative-tolerance, e.g. median:19")
      ->capture_default_str();
  app.add_option("--repeat", command.repeat, "runs per row")->capture_default_str();
  app.add_option("--subdivide", command.subdivide, "cut each model's triangles in four, so often");
  app.add_option("--json", command.json_path, "write the rows to this file as well");
  app.add_option("--keep", command.keep, "write the result of the last row to this file");
  app.add_option("--export", command.export_folder,
                 "write the models to this folder and do no more");
  CLI11_PARSE(app, argc, argv);
  try {
    if (command.export_folder.empty()) return run(command);
    std::filesystem::create_directories(command.export_folder);
    for (const Model& model : models_of(command)) {
      std::ofstream(std::filesystem::path(command.export_folder) / model.name, std::ios::binary)
          << model.bytes;
    }
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench: %s\n", error.what());
    return 2;
  }
}
