// SPDX-License-Identifier: MIT
#include "threads/share_work.h"

#include <algorithm>
#include <atomic>

#include "kdmanifold/error.h"
#include "kdmanifold/threads.h"
#include "text/compose.h"

#ifdef KDM_HAS_THREADS
#include "threads/thread_pool.h"
#endif

namespace kdm {
namespace {

std::atomic<int> count_set = 0;     // 0: as many as the machine runs at once
thread_local bool in_task = false;  // what a task shares, its thread does alone

// Marks this thread as one that is within a task.
class InTask {
 public:
  InTask() : before_(in_task) { in_task = true; }
  InTask(const InTask&) = delete;
  InTask& operator=(const InTask&) = delete;
  ~InTask() { in_task = before_; }

 private:
  bool before_;
};

}  // namespace

void set_thread_count(int count) {
  if (count < 0 || count > kMostThreads) {
    throw Error(ErrorCode::kInvalidOption,
                compose("threads is {}; it must be a whole number from 1 to {}, or 0, which stands "
                        "for as many as the machine runs at once",
                        count, kMostThreads));
  }
  count_set = count;
}

#ifdef KDM_HAS_THREADS

int thread_count() {
  if (count_set > 0) return count_set;
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, kMostThreads);
}

int workers() { return in_task ? 1 : thread_count(); }

void share_work(std::size_t tasks, int threads, const std::function<void(std::size_t, int)>& work) {
  const auto do_task = [&](std::size_t task, int worker) {
    const InTask marked;
    work(task, worker);
  };
  if (tasks > 1 && threads > 1 && !in_task) {
    static ThreadPool pool;
    if (pool.run(tasks, threads, do_task)) return;
  }
  for (std::size_t task = 0; task < tasks; ++task) do_task(task, 0);
}

#else

int thread_count() { return 1; }

int workers() { return 1; }

void share_work(std::size_t tasks, int, const std::function<void(std::size_t, int)>& work) {
  for (std::size_t task = 0; task < tasks; ++task) work(task, 0);
}

#endif

}  // namespace kdm
