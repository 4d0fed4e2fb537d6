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
  SplitStrategy strategy;
  int depth;
};

// "median:19"
Setting parse_setting(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) {
    throw Error(ErrorCode::kInvalidOption, "setting '" + text + "' must look like median:19");
  }
  return {strategy_from_name(text.substr(0, colon)), std::stoi(text.substr(colon + 1))};
}

json to_json(const Model& model, const Setting& setting, const Run& run) {
  return {{"model", model.name},
          {"engine", "native"},
          {"strategy", strategy_name(setting.strategy)},
          {"depth", setting.depth},
          {"input", {{"triangles", run.input.triangles}, {"vertices", run.input.vertices}}},
          {"grid",
           {{"cells", run.grid.cells},
            {"hits", run.grid.hits},
            {"bytes", run.grid.bytes},
            {"ambiguousFaces", run.grid.ambiguous_faces},
            {"guessedFaces", run.grid.guessed_faces}}},
          {"output",
           {{"triangles", run.output.triangles.size()},
            {"vertices", run.output.positions.size()},
            {"droppedPillows", run.output.report.dropped_pillows},
            {"insertedVertices", run.output.report.inserted_vertices}}},
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
  std::printf("%-24s %-7s %2d %8u %8zu %7.3f %7.3f %8.3f %8.3f %7.3f %6.2f %6.2f %6.0f\n",
              model.name.c_str(), strategy_name(setting.strategy), setting.depth,
              run.input.triangles, run.output.triangles.size(), stage(run, "read"), build, topology,
              vertices, stage(run, "total"), run.input.triangles / build / 1e6,
              static_cast<double>(run.output.triangles.size()) / (topology + vertices) / 1e6,
              static_cast<double>(run.peak_bytes) / 1e6);
  std::fflush(stdout);
}

int run(const std::vector<std::string>& paths, const std::vector<std::string>& settings, int repeat,
        const std::string& json_path) {
  json rows = json::array();
  std::printf("%-24s %-7s %2s %8s %8s %7s %7s %8s %8s %7s %6s %6s %6s\n", "model", "rule", "d",
              "in", "out", "read", "build", "topology", "vertices", "total", "Min/s", "Mout/s",
              "peakMB");
  for (const Model& model : load_models(paths)) {
    for (const std::string& text : settings) {
      const Setting setting = parse_setting(text);
      try {
        const Run result =
            run_median(model, {.strategy = setting.strategy, .depth = setting.depth}, repeat);
        print_row(model, setting, result);
        rows.push_back(to_json(model, setting, result));
      } catch (const Error& error) {
        std::printf("%-24s %-7s %2d %s\n", model.name.c_str(), strategy_name(setting.strategy),
                    setting.depth, error_code_name(error.code()));
        rows.push_back({{"model", model.name}, {"error", error_code_name(error.code())}});
        break;
      }
    }
  }
  if (!json_path.empty()) std::ofstream(json_path) << rows.dump(1) << '\n';
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Times the stages of mesh -> grid -> mesh: medians, in seconds.");
  std::vector<std::string> paths;
  std::vector<std::string> settings = {"adaptive:60", "median:19", "octree:21", "uniform:21"};
  int repeat = 5;
  std::string json_path;
  std::string export_folder;
  app.add_option("--models,models", paths, "files or folders; default: generated scenes");
  app.add_option("--settings", settings, "rule:depth, e.g. median:19")->capture_default_str();
  app.add_option("--repeat", repeat, "runs per row")->capture_default_str();
  app.add_option("--json", json_path, "write the rows to this file as well");
  app.add_option("--export", export_folder, "write the models to this folder and do no more");
  CLI11_PARSE(app, argc, argv);
  try {
    if (export_folder.empty()) return run(paths, settings, repeat, json_path);
    std::filesystem::create_directories(export_folder);
    for (const Model& model : load_models(paths)) {
      std::ofstream(std::filesystem::path(export_folder) / model.name, std::ios::binary)
          << model.bytes;
    }
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench: %s\n", error.what());
    return 2;
  }
}
