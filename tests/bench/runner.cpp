// SPDX-License-Identifier: MIT
#include "runner.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <fstream>

namespace kdm::bench {
namespace {

// Seconds that the processor has worked for this process, which has one thread: a busy machine
// makes them longer than they need be, but far less so than the time on the wall.
double now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

constexpr std::array<std::pair<const char*, SplitStrategy>, 5> kStrategies = {
    {{"adaptive", SplitStrategy::kAdaptive},
     {"octree", SplitStrategy::kOctree},
     {"feature", SplitStrategy::kFeature},
     {"median", SplitStrategy::kMedian},
     {"uniform", SplitStrategy::kUniform}}};

// Attributes the time between two calls of the progress callback to the phase named first: no
// private function is called, and the same works through the JavaScript wrapper.
class PhaseTimer {
 public:
  explicit PhaseTimer(StageSeconds& seconds) : seconds_(seconds) {}

  void enter(std::string_view phase) {
    const double time = now();
    if (!phase_.empty()) seconds_[phase_] += time - since_;
    phase_ = phase;
    since_ = time;
  }
  void leave() { enter({}); }
  Progress progress() {
    return [this](double, std::string_view phase) {
      if (phase != phase_) enter(phase);
      return true;
    };
  }

 private:
  StageSeconds& seconds_;
  std::string phase_;
  double since_ = 0;
};

// Linux keeps the process's high-water mark and forgets it on request.
void forget_peak() { std::ofstream("/proc/self/clear_refs") << "5"; }

std::size_t peak_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("VmHWM:", 0) == 0) return std::stoull(line.substr(6)) * 1024;
  }
  return 0;
}

}  // namespace

Run run_once(const Model& model, const BuildOptions& build, const ExtractOptions& extract_options) {
  Run run;
  forget_peak();
  PhaseTimer timer(run.seconds);
  const double start = now();
  timer.enter("read");
  const Mesh mesh = parse_mesh(model.bytes, model.format, model.name);
  timer.enter("prepare");
  const Grid grid = build_grid(mesh, build, timer.progress());
  timer.enter("extract");
  run.output = extract(grid, extract_options, timer.progress());
  timer.leave();
  run.seconds["total"] = now() - start;
  run.peak_bytes = peak_bytes();
  run.input = grid.input();
  run.grid = grid.stats();
  return run;
}

Run run_median(const Model& model, const BuildOptions& build, int repeat) {
  std::map<std::string, std::vector<double>> samples;
  Run run;
  for (int i = 0; i < repeat; ++i) {
    run = run_once(model, build);
    for (const auto& [stage, seconds] : run.seconds) samples[stage].push_back(seconds);
  }
  for (auto& [stage, values] : samples) {
    std::sort(values.begin(), values.end());
    run.seconds[stage] = values[values.size() / 2];
  }
  return run;
}

const char* strategy_name(SplitStrategy strategy) {
  for (const auto& [name, value] : kStrategies) {
    if (value == strategy) return name;
  }
  return "?";
}

SplitStrategy strategy_from_name(const std::string& wanted) {
  for (const auto& [name, value] : kStrategies) {
    if (wanted == name) return value;
  }
  throw Error(
      ErrorCode::kInvalidOption,
      "strategy is '" + wanted + "'; it must be adaptive, octree, feature, median or uniform");
}

}  // namespace kdm::bench
