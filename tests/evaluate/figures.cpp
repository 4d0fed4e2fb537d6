// SPDX-License-Identifier: MIT
// What must hold on every closed model of a folder, with the figures that a release notes:
// manifoldness at three depths by three rules, parts and Euler characteristic by depth, a cube's
// volume, and the seconds on the largest model. Exit status 1 if any result is not 2-manifold.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "runner.h"
#include "support/mesh_check.h"
#include "support/shapes.h"

namespace {

using namespace kdm;
using namespace kdm::bench;
using nlohmann::json;
namespace fs = std::filesystem;

constexpr std::array<SplitStrategy, 5> kStrategies = {
    SplitStrategy::kAdaptive, SplitStrategy::kOctree, SplitStrategy::kFeature,
    SplitStrategy::kMedian, SplitStrategy::kUniform};

struct Outcome {
  json rows = json::array();
  int failures = 0;
};

Model cube_model() {
  return {"cube", format_mesh(shapes::cube(), MeshFormat::kObj), MeshFormat::kObj};
}

void cube_volumes(Outcome& outcome) {
  std::puts("cube of 8 vertices: relative error of the volume");
  const Model model = cube_model();
  for (const auto& [strategy, depth] :
       {std::pair(SplitStrategy::kOctree, 9), std::pair(SplitStrategy::kUniform, 9),
        std::pair(SplitStrategy::kMedian, 21), std::pair(SplitStrategy::kAdaptive, 21)}) {
    const Run run = run_once(model, {.strategy = strategy, .depth = depth});
    const double error = std::abs(check::check_mesh(run.output).volume - 1);
    const bool good = error < 1e-5;
    outcome.failures += good ? 0 : 1;
    std::printf("  %-8s depth %2d  %.2e  %zu triangles%s\n", strategy_name(strategy), depth, error,
                run.output.triangles.size(), good ? "" : "   NOT within 1e-5");
    outcome.rows.push_back({{"figure", "cubeVolume"},
                            {"strategy", strategy_name(strategy)},
                            {"depth", depth},
                            {"error", error}});
  }
}

// Every model by every rule and depth; false if the model is not closed and was refused.
bool manifoldness(const Model& model, const std::vector<int>& depths, const std::string& keep,
                  Outcome& outcome) {
  for (const SplitStrategy strategy : kStrategies) {
    for (const int depth : depths) {
      Run run;
      try {
        run = run_once(model, {.strategy = strategy, .depth = depth});
      } catch (const Error& error) {
        std::printf("  %-24s %s\n", model.name.c_str(), error_code_name(error.code()));
        outcome.failures += error.code() == ErrorCode::kNotClosed ? 0 : 1;
        return false;
      }
      const check::MeshCheck result = check::check_mesh(run.output);
      outcome.failures += result.two_manifold ? 0 : 1;
      std::printf("  %-24s %-8s %2d %8zu triangles %5d parts, Euler %6lld  %s\n",
                  model.name.c_str(), strategy_name(strategy), depth, run.output.triangles.size(),
                  result.components, static_cast<long long>(result.euler_characteristic),
                  result.two_manifold ? "2-manifold" : result.faults().c_str());
      std::fflush(stdout);
      outcome.rows.push_back({{"figure", "manifold"},
                              {"model", model.name},
                              {"strategy", strategy_name(strategy)},
                              {"depth", depth},
                              {"triangles", run.output.triangles.size()},
                              {"closed", result.closed},
                              {"oriented", result.oriented},
                              {"twoManifold", result.two_manifold},
                              {"components", result.components},
                              {"eulerCharacteristic", result.euler_characteristic}});
      if (!keep.empty()) {
        const std::string name = fs::path(model.name).stem().string() + "_" +
                                 strategy_name(strategy) + "_" + std::to_string(depth) + ".obj";
        write_mesh((fs::path(keep) / name).string(), run.output);
      }
    }
  }
  return true;
}

void topology_by_depth(const Model& model, Outcome& outcome) {
  std::printf("  %-24s", model.name.c_str());
  for (const int depth : {15, 18, 21, 24, 27}) {
    const Run run = run_once(model, {.strategy = SplitStrategy::kOctree, .depth = depth});
    const check::MeshCheck result = check::check_mesh(run.output);
    std::printf("  %d: (%d, %lld)", depth, result.components,
                static_cast<long long>(result.euler_characteristic));
    std::fflush(stdout);
    outcome.rows.push_back({{"figure", "topology"},
                            {"model", model.name},
                            {"depth", depth},
                            {"components", result.components},
                            {"eulerCharacteristic", result.euler_characteristic}});
  }
  std::puts("");
}

void speed(const Model& model, Outcome& outcome) {
  const Run run = run_median(model, {.strategy = SplitStrategy::kMedian, .depth = 19}, 5);
  std::printf("seconds on %s by median at depth 19 (%u triangles in, %zu out), median of five:\n",
              model.name.c_str(), run.input.triangles, run.output.triangles.size());
  for (const auto& [stage, seconds] : run.seconds) {
    std::printf("  %-9s %.4f\n", stage.c_str(), seconds);
  }
  outcome.rows.push_back({{"figure", "seconds"},
                          {"model", model.name},
                          {"inputTriangles", run.input.triangles},
                          {"outputTriangles", run.output.triangles.size()},
                          {"seconds", run.seconds},
                          {"peakBytes", run.peak_bytes}});
}

int figures(const std::vector<std::string>& paths, const std::vector<int>& depths,
            const std::string& keep, const std::string& json_path) {
  Outcome outcome;
  cube_volumes(outcome);
  std::vector<Model> closed;
  std::puts("closed, oriented, 2-manifold:");
  for (const Model& model : load_models(paths)) {
    if (manifoldness(model, depths, keep, outcome)) closed.push_back(model);
  }
  std::puts("(parts, Euler characteristic) by octree depth:");
  const Model* largest = nullptr;
  for (const Model& model : closed) {
    topology_by_depth(model, outcome);
    if (largest == nullptr || model.bytes.size() > largest->bytes.size()) largest = &model;
  }
  if (largest != nullptr) speed(*largest, outcome);
  std::printf("%d failures\n", outcome.failures);
  if (!json_path.empty()) std::ofstream(json_path) << outcome.rows.dump(1) << '\n';
  return outcome.failures == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Properties and figures over a folder of models.");
  std::vector<std::string> paths;
  std::vector<int> depths = {12, 18, 24};
  std::string keep;
  std::string json_path;
  app.add_option("--models,models", paths, "files or folders; default: generated scenes");
  app.add_option("--depths", depths, "tree depths")->capture_default_str();
  app.add_option("--keep", keep, "write every result to this folder, for another judge");
  app.add_option("--json", json_path, "write the figures to this file as well");
  CLI11_PARSE(app, argc, argv);
  try {
    if (!keep.empty()) fs::create_directories(keep);
    return figures(paths, depths, keep, json_path);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "figures: %s\n", error.what());
    return 2;
  }
}
