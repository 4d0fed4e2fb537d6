// SPDX-License-Identifier: MIT
// Files that the command line writes are whole or absent.
#ifdef KDM_CLI_PATH

#include "cli/files.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include "kdmanifold/error.h"

namespace kdm::cli {
namespace {

namespace fs = std::filesystem;

class Files : public ::testing::Test {
 protected:
  Files() {
    const ::testing::TestInfo* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() /
              ("kdmanifold-files-" + std::string(info->name()) + "-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  ~Files() override { fs::remove_all(folder_); }

  std::string path(const char* name) const { return (folder_ / name).string(); }
  bool empty() const { return fs::is_empty(folder_); }

  fs::path folder_;
};

TEST_F(Files, WhatIsWrittenIsRead) {
  const std::string bytes("a\0b\r\n\xff", 6);
  write_all(path("a"), bytes);
  EXPECT_EQ(read_all(path("a")), bytes);
  write_all(path("a"), "");
  EXPECT_EQ(read_all(path("a")), "");
  EXPECT_THROW(read_all(path("b")), Error);
  EXPECT_THROW(write_all(path("b/c"), bytes), Error);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

// A signal comes while much is being written.
TEST_F(Files, SignalsLeaveNothing) {
  for (const int number : {SIGTERM, SIGINT, SIGHUP}) {
    const std::string bytes(std::size_t{1} << 28, 'x');
    int status = 0;
    for (int attempt = 0; attempt < 50; ++attempt) {  // should it all be written too soon
      const pid_t child = ::fork();
      ASSERT_GE(child, 0);
      if (child == 0) {
        ::setpriority(PRIO_PROCESS, 0, 19);  // so that on a busy machine the signal is not late
        write_all(path("a"), bytes);
        ::_exit(0);
      }
      while (empty() && ::waitpid(child, &status, WNOHANG) == 0) ::usleep(100);
      ::kill(child, number);
      ::waitpid(child, &status, 0);
      if (WIFSIGNALED(status)) break;
      fs::remove(path("a"));
    }
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), number);
    EXPECT_TRUE(empty());
  }
}

TEST_F(Files, HandlersAreThereOnlyWhileSomethingIsWritten) {
  write_all(path("a"), "x");
  EXPECT_EQ(std::signal(SIGTERM, SIG_DFL), SIG_DFL);
  std::signal(SIGINT, SIG_IGN);
  write_all(path("a"), "x");
  EXPECT_EQ(std::signal(SIGINT, SIG_DFL), SIG_IGN) << "as after nohup";
}

TEST_F(Files, RefusesBeforeTheWork) {
  write_all(path("a"), "x");
  EXPECT_THROW(check_target(path("a"), false), Error);
  EXPECT_NO_THROW(check_target(path("a"), true));
  EXPECT_NO_THROW(check_target(path("b"), false));
  EXPECT_THROW(check_target(folder_.string(), true), Error);
  EXPECT_THROW(check_folder_of(path("b/c")), Error);
  EXPECT_THROW(check_folder_of(path("a/c")), Error);
  EXPECT_NO_THROW(check_folder_of(path("b")));
  if (::geteuid() == 0) return;  // who may write everywhere
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THROW(check_folder_of(path("b")), Error);
  fs::permissions(folder_, fs::perms::owner_all);
}

}  // namespace
}  // namespace kdm::cli

#endif  // KDM_CLI_PATH
