// SPDX-License-Identifier: MIT
// Reads and writes whole files. Nothing here is used in the WebAssembly build, which has no files.
#include "io/files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>

#include "kdmanifold/error.h"
#include "text/compose.h"

namespace kdm {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

[[noreturn]] void fail(const std::string& path, const char* what, int error) {
  throw Error(ErrorCode::kIoError, compose("{}: {}: {}", path, what, std::strerror(error)));
}

// A file that is removed again unless it is kept.
class TemporaryFile {
 public:
  // Creates the file in the folder of the target: a file can be renamed in one step only within a
  // folder.
  explicit TemporaryFile(const std::string& target) : target_(target) {
    for (int attempt = 0; !file_ && attempt < 1000; ++attempt) {
      path_ = compose("{}.{}.part", target, attempt);
      file_.reset(std::fopen(path_.c_str(), "wbx"));  // x: fails where it exists
      if (!file_ && errno != EEXIST) break;
    }
    if (!file_) fail(target_, "cannot be written", errno);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (path_.empty()) return;
    file_.reset();
    std::remove(path_.c_str());
  }

  void write_and_keep(std::string_view bytes) {
    errno = 0;
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) == bytes.size();
    // Closing writes what is still in memory, and may fail as well.
    if (std::fclose(file_.release()) != 0 || !written) fail(target_, "cannot be written", errno);
    std::error_code error;
    std::filesystem::rename(path_, target_, error);
    if (error) fail(target_, "cannot be written", error.value());
    path_.clear();
  }

 private:
  std::string target_;
  std::string path_;
  File file_;
};

}  // namespace

std::string read_file(const std::string& path) {
  const File file(std::fopen(path.c_str(), "rb"));
  if (!file) fail(path, "cannot be opened", errno);
  std::string bytes;
  std::error_code unknown;  // a pipe has no size: then the string grows as it is read
  const std::uintmax_t size = std::filesystem::file_size(path, unknown);
  if (!unknown) bytes.reserve(static_cast<std::size_t>(size) + 1);
  constexpr std::size_t kBlock = std::size_t{1} << 20;
  while (true) {
    const std::size_t before = bytes.size();
    bytes.resize(before + kBlock);
    errno = 0;
    const std::size_t count = std::fread(bytes.data() + before, 1, kBlock, file.get());
    bytes.resize(before + count);
    if (count < kBlock) break;
  }
  if (std::ferror(file.get())) fail(path, "cannot be read", errno);
  return bytes;
}

void write_file(const std::string& path, std::string_view bytes) {
  TemporaryFile(path).write_and_keep(bytes);
}

}  // namespace kdm
