// SPDX-License-Identifier: MIT
// The native command line. Exit status 0: done; 1: --check found an output not 2-manifold; 2: bad
// input or option, one line of error each.
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "cli/convert.h"
#include "cli/options.h"
#include "cli/report_json.h"
#include "cli/report_text.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace kdm::cli {
namespace {

constexpr int kNotManifold = 1;
constexpr int kBadInput = 2;

// Prints one line on standard error. Messages may quote file names, which may hold any character.
void say(std::string message) {
  for (char& c : message) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  std::fprintf(stderr, "kdmanifold: %s\n", message.c_str());
}

// Does the tasks one after the other, and remembers how they ended.
class Run {
 public:
  explicit Run(const Command& command)
      : command_(command),
        tasks_(plan(command)),
        reports_to_(command.files.output == kStandardStream ? stderr : stdout),
        progress_(!command.report.quiet && isatty(STDERR_FILENO) != 0) {}

  int finish() {
    set_thread_count(command_.report.threads);
    for (const Task& task : tasks_) perform(task);
    if (several() && command_.report.json) print(list_.dump(2) + "\n");
    if (printed_ > 0 && converts(command_) && !writes(command_.files)) {
      print(several() ? "\nnothing was written: --out-dir DIR keeps the results\n"
                      : "nothing was written: -o FILE keeps the result\n");
    }
    return failed_ ? kBadInput : not_manifold_ ? kNotManifold : 0;
  }

 private:
  bool several() const { return tasks_.size() > 1; }

  void print(const std::string& text) {
    if (!command_.report.quiet) std::fwrite(text.data(), 1, text.size(), reports_to_);
  }

  void perform(const Task& task) {
    if (several()) {
      progress_.begin(std::to_string(++begun_) + " of " + std::to_string(tasks_.size()) + ": ");
    }
    try {
      const RunReport report = convert(command_, task, progress_);
      progress_.clear();
      tell(report, task);
    } catch (const Error& error) {
      progress_.clear();
      say(error.what());
      failed_ = true;
      list_.push_back({{"file", task.input}, {"error", error.what()}});
    }
  }

  void tell(const RunReport& report, const Task& task) {
    if (!command_.report.json) {
      if (printed_++ > 0) print("\n");
      print(report_as_text(report, command_, task));
    } else if (!several()) {
      print(report_as_json(report, command_).dump(2) + "\n");
    } else {
      Json json = {{"file", task.input}};
      json.update(report_as_json(report, command_));
      list_.push_back(std::move(json));
    }
    if (command_.report.check && !passes_check(report.output, report.grid.sheet)) {
      not_manifold_ = true;
    }
  }

  const Command& command_;
  std::vector<Task> tasks_;
  std::FILE* reports_to_;
  ProgressLine progress_;
  Json list_ = Json::array();  // the reports of several inputs
  std::size_t begun_ = 0;
  std::size_t printed_ = 0;  // reports for people
  bool failed_ = false;
  bool not_manifold_ = false;
};

// Keeps what one step gives back for the next one: getting memory anew from the system took a
// twentieth of the time of large inputs.
void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int kMebibyte = 1 << 20;
  mallopt(M_TRIM_THRESHOLD, 256 * kMebibyte);
  mallopt(M_MMAP_THRESHOLD, 32 * kMebibyte);
#endif
}

int run_safely(int argc, const char* const* argv) {
  std::signal(SIGPIPE, SIG_IGN);  // writing into a closed pipe is an error like others
  try {
    const Command command = parse_command({argv + std::min(argc, 1), argv + argc});
    if (!command.answer.empty()) {
      std::fwrite(command.answer.data(), 1, command.answer.size(), stdout);
      return 0;
    }
    return Run(command).finish();
  } catch (const std::bad_alloc&) {
    say("not enough memory");
  } catch (const std::exception& error) {
    say(error.what());
  }
  return kBadInput;
}

}  // namespace
}  // namespace kdm::cli

int main(int argc, char** argv) {
  kdm::cli::keep_freed_memory();
  return kdm::cli::run_safely(argc, argv);
}
