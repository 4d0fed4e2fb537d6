// SPDX-License-Identifier: MIT
// The steps for one input in their order.
#include "cli/convert.h"

#include <sys/resource.h>

#include <chrono>
#include <new>

#include "cli/files.h"
#include "cli/mesh_files.h"

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
    check_target(task.output, files.force);
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
                   const Mesh& mesh, const Grid& grid) {
  const FileOptions& files = command.files;
  if (!task.output.empty()) {
    const bool exact = command.extract.strict == Strict::kEmbedded;
    const std::string bytes =
        format_file(mesh, formats.output, exact ? Digits::kExact : Digits::kShortest);
    if (!files.out_dir.empty()) make_folder(files.out_dir);
    write_all(task.output, bytes);
  }
  if (!files.save_grid.empty()) write_grid_file(files.save_grid, grid);
}

// The steps, which fill in the report.
void work(const Command& command, const Task& task, ProgressLine& progress, RunReport& report) {
  const Formats formats = check_files(command, task);
  Stopwatch watch;
  Grid grid;
  Mesh input;
  progress.show("reading");
  if (task.is_grid) {
    grid = read_grid_file(task.input);
    report.seconds.read = watch.lap();
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
    grid = build_grid(read.mesh, command.build, progress.of("building"));
    input = std::move(read.mesh);
    report.seconds.build = watch.lap();
  }
  ExtractedMesh result = extract(grid, command.extract, progress.of("extracting"));
  round_to_single(result);
  report.seconds.extract = watch.lap();
  progress.show("writing");
  write_results(command, task, formats, result, grid);
  report.seconds.write = watch.lap();
  progress.show("checking");
  report.input = grid.input();
  report.grid = grid.stats();
  report.output = describe(result);
  report.extracted = result.report;
  const auto warn = [&](const std::vector<Warning>& of) {
    report.warnings.insert(report.warnings.end(), of.begin(), of.end());
  };
  if (!task.is_grid) {
    const Account account = compare(input, grid, result, {.error = command.report.check});
    report.lost = account.lost;
    report.error = account.error;
    warn(account.warnings);
  }
  warn(result.warnings);
  if (command.report.check) report.self_intersections = find_self_intersections(result).pairs;
}

// Errors of files name these already, others are about the input. Options are called as they were
// typed.
std::string message_of(const Error& error, const Command& command, const Task& task) {
  std::string message = with_typed_names(command, error.what());
  const std::string name = input_name(task.input);
  if (error.code() == ErrorCode::kIoError || message.rfind(name + ": ", 0) == 0) return message;
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
