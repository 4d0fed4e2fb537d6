// SPDX-License-Identifier: MIT
// The native command line: read, analyze, build (or load), extract, write, report. Exit status 0:
// done; 1: --check found the output not 2-manifold; 2: bad input or option, one line of error.
#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "cli/options.h"
#include "cli/report_json.h"
#include "cli/report_text.h"

namespace kdm::cli {
namespace {

constexpr int kNotManifold = 1;
constexpr int kBadInput = 2;

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

void print(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stdout); }

// Rounds coordinates to 32 bits, as files and JavaScript's results have them: the report describes
// these.
void round_to_single(Mesh& mesh) {
  for (Vec3& p : mesh.positions) p = p.cast<float>().cast<double>();
}

// Prints the report and returns the exit status.
int finish(RunReport& report, const Command& command) {
  report.peak_bytes = peak_bytes();
  print(command.json ? report_as_json(report, command) : report_as_text(report, command));
  return command.check && !passes_check(report.output, report.grid.sheet) ? kNotManifold : 0;
}

int run(const Command& command) {
  // Refuses an unknown output format before the work rather than after it.
  if (!command.output.empty()) format_from_path(command.output);

  RunReport report;
  Stopwatch watch;
  Grid grid;
  if (names_a_grid(command.input)) {
    grid = read_grid(command.input);
    report.seconds.read = watch.lap();
  } else {
    const Mesh mesh = read_mesh(command.input);
    report.seconds.read = watch.lap();
    if (command.stats) report.defects = analyze(mesh, {.self_intersections = true});
    report.seconds.analyze = watch.lap();
    if (!converts(command)) return finish(report, command);
    grid = build_grid(mesh, command.build);
    report.seconds.build = watch.lap();
  }
  ExtractedMesh result = extract(grid, command.extract);
  round_to_single(result);
  report.seconds.extract = watch.lap();
  const bool exact = command.extract.strict == Strict::kEmbedded;
  if (!command.output.empty()) {
    write_mesh(command.output, result, exact ? Digits::kExact : Digits::kShortest);
  }
  if (!command.save_grid.empty()) write_grid(command.save_grid, grid);
  report.seconds.write = watch.lap();
  report.input = grid.input();
  report.grid = grid.stats();
  report.output = describe(result);
  report.extracted = result.report;
  if (command.check) report.self_intersections = find_self_intersections(result).pairs;
  return finish(report, command);
}

// Prints one line of error. Messages may quote file names, which may hold any character.
int complain(std::string message) {
  for (char& c : message) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  std::fprintf(stderr, "kdmanifold: %s\n", message.c_str());
  return kBadInput;
}

int run_safely(int argc, const char* const* argv) {
  try {
    const Command command = parse_command(argc, argv);
    if (!command.answer.empty()) {
      print(command.answer);
      return 0;
    }
    try {
      return run(command);
    } catch (const Error& error) {
      // Errors of reading and writing name the file already.
      const std::string message = error.what();
      const bool named = message.find(command.input) == 0 || error.code() == ErrorCode::kIoError;
      return complain(named ? message : command.input + ": " + message);
    }
  } catch (const UsageError& error) {
    return complain(error.what());
  } catch (const std::bad_alloc&) {
    return complain("not enough memory");
  } catch (const std::exception& error) {
    return complain(error.what());
  }
}

}  // namespace
}  // namespace kdm::cli

int main(int argc, char** argv) { return kdm::cli::run_safely(argc, argv); }
