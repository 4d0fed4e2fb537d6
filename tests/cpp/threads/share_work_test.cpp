// SPDX-License-Identifier: MIT
#include "threads/share_work.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "kdmanifold/error.h"
#include "kdmanifold/threads.h"
#include "support/threads.h"

namespace kdm {
namespace {

constexpr std::size_t kTasks = 1000;

TEST(ShareWork, DoesEachTaskOnce) {
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadCount set(threads);
    EXPECT_EQ(workers(), threads);
    std::vector<std::atomic<int>> done(kTasks);
    share_work(kTasks, workers(), [&](std::size_t task, int) { ++done[task]; });
    for (const std::atomic<int>& times : done) ASSERT_EQ(times, 1) << threads << " threads";
  }
}

TEST(ShareWork, GivesNoTwoTasksAtATimeTheSameWorker) {
  const ThreadCount set(4);
  std::array<std::atomic<int>, 4> at_work{};
  std::atomic<int> faults = 0;
  const std::thread::id caller = std::this_thread::get_id();
  share_work(kTasks, workers(), [&](std::size_t, int worker) {
    if (worker < 0 || worker >= 4) {
      ++faults;
      return;
    }
    if (++at_work[static_cast<std::size_t>(worker)] != 1) ++faults;
    if ((worker == 0) != (std::this_thread::get_id() == caller)) ++faults;
    std::this_thread::yield();
    --at_work[static_cast<std::size_t>(worker)];
  });
  EXPECT_EQ(faults, 0);
}

// Threads that an earlier call has made take no part in one for fewer.
TEST(ShareWork, UsesNoMoreWorkersThanThreadsOrTasks) {
  const ThreadCount set(8);
  const auto highest = [](std::size_t tasks, int threads) {
    std::atomic<int> most = 0;
    share_work(tasks, threads, [&](std::size_t, int worker) {
      for (int seen = most; worker > seen && !most.compare_exchange_weak(seen, worker);) continue;
      std::this_thread::yield();
    });
    return most.load();
  };
  for (int i = 0; i < 200; ++i) {
    EXPECT_LT(highest(kTasks, 8), 8);
    EXPECT_LT(highest(kTasks, 2), 2);
    EXPECT_LT(highest(3, 8), 3);
  }
}

TEST(ShareWork, UsesSeveralThreadsAtATime) {
  const ThreadCount set(2);
  // The first two tasks wait for each other.
  std::atomic<int> begun = 0;
  share_work(2, workers(), [&](std::size_t, int) {
    ++begun;
    while (begun < 2) std::this_thread::yield();
  });
  EXPECT_EQ(begun, 2);
}

TEST(ShareWork, ThrowsWhatTheFirstFailingTaskThrew) {
  for (const int threads : {1, 2, 8}) {
    const ThreadCount set(threads);
    std::atomic<std::size_t> last = 0;
    try {
      share_work(kTasks, workers(), [&](std::size_t task, int) {
        if (task >= 3) throw Error(ErrorCode::kAborted, std::to_string(task));
        last = std::max<std::size_t>(last, task);
      });
      FAIL() << "nothing was thrown";
    } catch (const Error& error) {
      // Tasks begin in their order, so task 3 failed whatever else did.
      EXPECT_STREQ(error.what(), "3");
    }
    EXPECT_LT(last, 3u);
    // The threads are there for the next call.
    std::atomic<std::size_t> done = 0;
    share_work(kTasks, workers(), [&](std::size_t, int) { ++done; });
    EXPECT_EQ(done, kTasks);
  }
}

TEST(ShareWork, DoesWhatATaskSharesOnItsOwnThread) {
  const ThreadCount set(4);
  std::atomic<std::size_t> done = 0;
  std::atomic<int> faults = 0;
  share_work(20, workers(), [&](std::size_t, int) {
    if (workers() != 1) ++faults;
    const std::thread::id own = std::this_thread::get_id();
    share_work(20, 4, [&](std::size_t, int worker) {
      ++done;
      if (worker != 0 || std::this_thread::get_id() != own) ++faults;
    });
  });
  EXPECT_EQ(done, 400u);
  EXPECT_EQ(faults, 0);
  EXPECT_EQ(workers(), 4);
}

TEST(ShareWork, MayBeCalledByTwoThreads) {
  const ThreadCount set(3);
  std::atomic<std::size_t> done = 0;
  const auto call = [&] {
    for (int i = 0; i < 50; ++i) share_work(40, workers(), [&](std::size_t, int) { ++done; });
  };
  std::thread other(call);
  call();
  other.join();
  EXPECT_EQ(done, 2u * 50 * 40);
}

TEST(ShareWork, DividesIntoPartsOfAboutEqualSize) {
  for (const std::size_t count : {0, 1, 7, 100, 1001}) {
    for (const std::size_t parts : {1, 2, 7, 100}) {
      EXPECT_EQ(begin_of_part(count, 0, parts), 0u);
      EXPECT_EQ(begin_of_part(count, parts, parts), count);
      for (std::size_t i = 0; i < parts; ++i) {
        const std::size_t size =
            begin_of_part(count, i + 1, parts) - begin_of_part(count, i, parts);
        EXPECT_GE(size, count / parts);
        EXPECT_LE(size, count / parts + 1);
      }
    }
  }
}

TEST(ShareParts, AreTheSameWithAnyNumberOfThreads) {
  for (const int threads : {1, 2, 8}) {
    const ThreadCount set(threads);
    for (const std::size_t count : {0, 1, 9, 10, 11, 1000}) {
      std::vector<std::atomic<int>> done(count);
      share_parts(count, 10, [&](std::size_t begin, std::size_t end) {
        if (begin % 10 != 0 || end != std::min(begin + 10, count)) return;
        for (std::size_t i = begin; i < end; ++i) ++done[i];
      });
      for (const std::atomic<int>& times : done) ASSERT_EQ(times, 1) << count;
    }
  }
}

TEST(Threads, AreAsManyAsWereAskedFor) {
  set_thread_count(0);
  EXPECT_GE(thread_count(), 1);
  const ThreadCount set(5);
  EXPECT_EQ(thread_count(), 5);
  for (const int count : {-1, 257}) {
    try {
      set_thread_count(count);
      FAIL() << count;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kInvalidOption);
      EXPECT_EQ(std::string(error.what()),
                "threads is " + std::to_string(count) +
                    "; it must be a whole number from 1 to 256, or 0, which stands for as many as "
                    "the machine runs at once");
    }
  }
  EXPECT_EQ(thread_count(), 5);
}

}  // namespace
}  // namespace kdm
