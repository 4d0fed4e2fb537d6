// SPDX-License-Identifier: MIT
// The steps for one input in their order.
#include "cli/convert.h"

#include <sys/resource.h>

#include <chrono>
#include <new>
#include <optional>

#include "cli/files.h"
#include "cli/mesh_files.h"
#include "cli/solids.h"

namespace kdm::cli {
namespace {

// Measures the steps one after the other.
class Stopwatch {
 public:
  /// Returns the seconds since the last call, or since the start.
  double lap() {
    const Clock::time_point now = Clock::now();
    const std::chrono::duration<double> seconds = now - last_;
    last_ = now;
    return seconds.count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
};

// The most memory that the process has held; 0 if nobody knows.
std::uint64_t peak_bytes() {
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) != 0) return 0;
#ifdef __APPLE__
  return static_cast<std::uint64_t>(usage.ru_maxrss);  // bytes there, kilobytes elsewhere
#else
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
#endif
}

// Rounds coordinates to 32 bits, as files and JavaScript's results have them: the report describes
// these.
void round_to_single(Mesh& mesh) {
  for (Vec3& p : mesh.positions) p = p.cast<float>().cast<double>();
}

// What a task's files are.
struct Formats {
  FileFormat input = FileFormat::kByName;   // not of grids
  FileFormat output = FileFormat::kByName;  // only if there is one
};

// The files of the result: one, or one for each of several levels. Empty if none is written.
std::vector<std::string> paths_of(const Command& command, const Task& task) {
  const std::size_t levels = command.reduction.target_triangles.size();
  if (task.output.empty()) return {};
  if (levels < 2) return {task.output};
  std::vector<std::string> paths;
  for (std::size_t i = 1; i <= levels; ++i) paths.push_back(level_path(task.output, i));
  return paths;
}

// Refuses before the work what can be refused then.
Formats check_files(const Command& command, const Task& task) {
  const FileOptions& files = command.files;
  Formats formats;
  if (!task.is_grid) formats.input = input_format(task.input, files.input_format);
  if (!task.output.empty()) {
    formats.output = output_format(task.output, files.format);
    if (command.extract.normals && formats.output != FileFormat::kObj &&
        formats.output != FileFormat::kGlb) {
      throw Error(ErrorCode::kInvalidOption,
                  "`normals`: of the files only .obj and .glb have them");
    }
    for (const std::string& path : paths_of(command, task)) check_target(path, files.force);
    // The folder of --out-dir was checked, and may not be there yet.
    if (files.out_dir.empty()) check_folder_of(task.output);
  }
  if (!files.save_grid.empty()) {
    check_target(files.save_grid, files.force);
    check_folder_of(files.save_grid);
  }
  return formats;
}

void write_results(const Command& command, const Task& task, const Formats& formats,
                   const MadeMesh& made, const Grid& grid, RunReport& report) {
  const FileOptions& files = command.files;
  const std::vector<std::string> paths = paths_of(command, task);
  const bool embedded = made.report.crossings.has_value();
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const Mesh& mesh = paths.size() > 1 ? static_cast<const Mesh&>(made.levels[i]) : made;
    const std::string bytes =
        format_file(mesh, formats.output, embedded ? Digits::kExact : Digits::kShortest);
    if (!files.out_dir.empty()) make_folder(files.out_dir);
    write_all(paths[i], bytes);
  }
  for (std::size_t i = 0; i < made.levels.size(); ++i) {
    report.levels.push_back({static_cast<Index>(made.levels[i].triangles.size()),
                             paths.empty() ? "" : paths[i], made.levels[i].error});
  }
  if (!files.save_grid.empty()) write_grid_file(files.save_grid, grid);
}

// Takes the time of the steps, and shows how far each is.
class Steps {
 public:
  Steps(Stopwatch& watch, ProgressLine& progress, Seconds& seconds)
      : watch_(watch), progress_(progress), seconds_(seconds) {}

  Progress begin(MakeStep step) {
    end();
    switch (step) {
      case MakeStep::kBuild:
        running_ = &seconds_.build;
        return progress_.of("building");
      case MakeStep::kSimplify:
        running_ = &seconds_.simplify;
        return progress_.of("simplifying");
      case MakeStep::kExtract:
        running_ = &seconds_.extract;
        return progress_.of("extracting");
      case MakeStep::kReduce:
        break;
    }
    running_ = &seconds_.reduce;
    return progress_.of("reducing");
  }
  // Ends the step that runs.
  void end() {
    const double seconds = watch_.lap();
    if (running_ != nullptr) *running_ = seconds;
  }

 private:
  Stopwatch& watch_;
  ProgressLine& progress_;
  Seconds& seconds_;
  double* running_ = nullptr;
};

// The steps, which fill in the report.
void work(const Command& command, const Task& task, ProgressLine& progress, RunReport& report) {
  const Formats formats = check_files(command, task);
  Stopwatch watch;
  Steps timed_steps(watch, progress, report.seconds);
  const StepProgress steps = [&](MakeStep step) { return timed_steps.begin(step); };
  MadeManifold made;
  std::optional<Mesh> input;  // if it is one mesh, and no grid
  progress.show("reading");
  if (task.is_grid) {
    if (joins_solids(command)) {
      made.grid = merge_grids_of(command, task.input, steps(MakeStep::kBuild));
    } else {
      made.grid = read_grid_file(task.input);
      report.seconds.read = watch.lap();
    }
    static_cast<MadeMesh&>(made) =
        make_from_grid(made.grid, command.extract, command.reduction, steps);
  } else {
    ReadMesh read = read_mesh_file(task.input, formats.input);
    report.warnings = std::move(read.warnings);
    report.seconds.read = watch.lap();
    if (command.report.stats) {
      progress.show("analyzing");
      report.defects = analyze(read.mesh, {.self_intersections = true});
    }
    report.seconds.analyze = watch.lap();
    if (!converts(command)) return;
    if (joins_solids(command)) {
      made = make_solids(command, input_name(task.input), read.mesh, steps, report);
    } else {
      made = make_manifold_in_steps(read.mesh, {command.build, command.extract, command.reduction},
                                    steps);
      input = std::move(read.mesh);
    }
  }
  timed_steps.end();
  round_to_single(made);
  for (Mesh& level : made.levels) round_to_single(level);
  progress.show("writing");
  write_results(command, task, formats, made, made.grid, report);
  report.seconds.write = watch.lap();
  progress.show("checking");
  report.input = made.grid.input();
  report.operands = made.grid.operands();
  report.grid = made.stats;
  report.output = describe(made);
  report.extracted = made.report;
  report.simplified = made.simplified;
  report.reduced = made.reduced;
  const auto warn = [&](const std::vector<Warning>& of) {
    report.warnings.insert(report.warnings.end(), of.begin(), of.end());
  };
  if (input) {
    const Account account = compare(*input, made.grid, made, {.error = command.report.check});
    report.lost = account.lost;
    report.error = account.error;
    warn(account.warnings);
  }
  warn(made.warnings);
  if (command.report.check) report.self_intersections = find_self_intersections(made).pairs;
}

// Errors of files name these already, others are about the input. Options are called as they were
// typed.
std::string message_of(const Error& error, const Command& command, const Task& task) {
  std::string message = with_typed_names(command, error.what());
  const std::string name = input_name(task.input);
  const auto names = [&](const std::string& file) { return message.rfind(file + ": ", 0) == 0; };
  if (error.code() == ErrorCode::kIoError || names(name)) return message;
  for (const RepeatedArgument& argument : command.solids) {
    if (names(argument.value)) return message;
  }
  if (error.code() == ErrorCode::kInvalidOption) {
    const std::size_t end = message.find_first_of(" :");
    const auto typed = command.typed.find("--" + kebab_case(message.substr(0, end)));
    if (typed != command.typed.end()) message = typed->second + message.substr(end);
  }
  return name + ": " + message;
}

}  // namespace

RunReport convert(const Command& command, const Task& task, ProgressLine& progress) {
  RunReport report;
  try {
    work(command, task, progress, report);
  } catch (const Error& error) {
    throw Error(error.code(), message_of(error, command, task));
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::kOutOfMemory, input_name(task.input) + ": not enough memory");
  }
  report.peak_bytes = peak_bytes();
  return report;
}

}  // namespace kdm::cli
