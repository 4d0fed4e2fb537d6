// SPDX-License-Identifier: MIT
// Reads and writes whole files. cli-files.ts does the same, word for word.
#include "cli/files.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>

#include "cli/file_format.h"
#include "kdmanifold/error.h"

namespace kdm::cli {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

std::string reason(int error) {
  switch (error) {
    case ENOENT:
      return "there is no such file or folder";
    case EACCES:
    case EPERM:
      return "it is not permitted";
    case EISDIR:
      return "it is a folder";
    case ENOTDIR:
      return "a part of its path is no folder";
    case ENOSPC:
      return "no space is left";
    case EROFS:
      return "nothing can be written there";
    case EFBIG:
      return "the file would be too large";
    case EPIPE:
      return "nobody reads it any more";
    case ENAMETOOLONG:
      return "the name is too long";
    default:
      return fmt::format("error {} of the system", error);
  }
}

[[noreturn]] void fail(const std::string& name, const std::string& what) {
  throw Error(ErrorCode::kIoError, name + ": " + what);
}
[[noreturn]] void fail_to_read(const std::string& name, int error) {
  fail(name, "cannot be read: " + reason(error));
}
[[noreturn]] void fail_to_write(const std::string& name, int error) {
  fail(name, "cannot be written: " + reason(error));
}

// What a path leads to.
enum class Kind { kNothing, kFile, kFolder, kOther };

Kind kind_of(const std::string& path) {
  struct stat status;
  if (stat(path.c_str(), &status) != 0) return Kind::kNothing;
  if (S_ISREG(status.st_mode)) return Kind::kFile;
  return S_ISDIR(status.st_mode) ? Kind::kFolder : Kind::kOther;
}

std::string parent_of(const std::string& path) {
  const std::string parent = std::filesystem::path(path).parent_path().string();
  return parent.empty() ? "." : parent;
}

// Where a file is written before it has its name. Signals may come at any time.
char unfinished[4096] = "";

extern "C" void remove_unfinished(int number) {
  if (unfinished[0] != '\0') unlink(unfinished);
  std::signal(number, SIG_DFL);
  std::raise(number);
}

// Those that are ignored (nohup) stay so.
void handle_signals(void (*handler)(int)) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    if (std::signal(number, handler) == SIG_IGN) std::signal(number, SIG_IGN);
  }
}

// Holds back these signals as long as it exists; those that came are delivered then.
class HeldSignals {
 public:
  HeldSignals() {
    sigset_t held;
    sigemptyset(&held);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&held, number);
    sigprocmask(SIG_BLOCK, &held, &before_);
  }
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;
  ~HeldSignals() { sigprocmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_;
};

// A file that is removed again unless it is kept.
class TemporaryFile {
 public:
  // In the folder of the target: a file can be renamed in one step only within a folder.
  explicit TemporaryFile(const std::string& target) : target_(target) {
    const HeldSignals held;  // until the handler knows of the file
    for (int attempt = 0; !file_ && attempt < 1000; ++attempt) {
      path_ = fmt::format("{}.{}.part", target, attempt);
      file_.reset(std::fopen(path_.c_str(), "wbx"));  // x: fails where it exists
      if (!file_ && errno != EEXIST) break;
    }
    if (!file_) fail_to_write(target, errno);
    if (path_.size() < sizeof unfinished) path_.copy(unfinished, path_.size());
    handle_signals(remove_unfinished);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    file_.reset();
    if (!path_.empty()) std::remove(path_.c_str());
    handle_signals(SIG_DFL);
    std::fill(std::begin(unfinished), std::end(unfinished), '\0');
  }

  void write_and_keep(std::string_view bytes) {
    errno = 0;
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) == bytes.size();
    // Closing writes what is still in memory, and may fail as well.
    if (std::fclose(file_.release()) != 0 || !written) fail_to_write(target_, errno);
    if (std::rename(path_.c_str(), target_.c_str()) != 0) fail_to_write(target_, errno);
    path_.clear();
  }

 private:
  std::string target_;
  std::string path_;
  File file_;
};

void write_stream(std::FILE* stream, const std::string& name, std::string_view bytes) {
  errno = 0;
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), stream) == bytes.size();
  if (std::fflush(stream) != 0 || !written) fail_to_write(name, errno);
}

}  // namespace

std::string read_all(const std::string& path) {
  const bool standard = path == kStandardStream;
  const std::string name = input_name(path);
  const File opened(standard ? nullptr : std::fopen(path.c_str(), "rb"));
  if (!standard && !opened) fail_to_read(name, errno);
  std::FILE* const file = standard ? stdin : opened.get();
  std::string bytes;
  std::error_code unknown;  // a pipe has no size: then the string grows as it is read
  const std::uintmax_t size = standard ? 0 : std::filesystem::file_size(path, unknown);
  if (!unknown) bytes.reserve(static_cast<std::size_t>(size) + 1);
  constexpr std::size_t kBlock = std::size_t{1} << 20;
  while (true) {
    const std::size_t before = bytes.size();
    bytes.resize(before + kBlock);
    errno = 0;
    const std::size_t count = std::fread(bytes.data() + before, 1, kBlock, file);
    bytes.resize(before + count);
    if (count < kBlock) break;
  }
  if (std::ferror(file)) fail_to_read(name, errno);
  return bytes;
}

void check_folder(const std::string& folder, const std::string& subject) {
  const Kind kind = kind_of(folder);
  if (kind == Kind::kNothing) fail(subject, "there is no folder " + folder);
  if (kind != Kind::kFolder) fail(subject, folder + " is no folder");
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    fail(subject, "nothing can be written into the folder " + folder);
  }
}

void check_target(const std::string& path, bool force) {
  if (path == kStandardStream) return;
  const Kind kind = kind_of(path);
  if (kind == Kind::kFolder) fail(path, "it is a folder; --out-dir puts results into folders");
  if (kind == Kind::kFile && !force) fail(path, "it exists already; --force overwrites it");
}

void check_folder_of(const std::string& path) {
  if (path == kStandardStream || kind_of(path) == Kind::kOther) return;
  check_folder(parent_of(path), path);
}

void write_all(const std::string& path, std::string_view bytes) {
  if (path == kStandardStream) return write_stream(stdout, "standard output", bytes);
  if (kind_of(path) != Kind::kOther) return TemporaryFile(path).write_and_keep(bytes);
  const File file(std::fopen(path.c_str(), "wb"));
  if (!file) fail_to_write(path, errno);
  write_stream(file.get(), path, bytes);
}

void make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directory(folder, error);
  if (error) fail(folder, "cannot be made: " + reason(error.value()));
}

}  // namespace kdm::cli
