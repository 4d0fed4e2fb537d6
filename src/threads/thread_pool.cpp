// SPDX-License-Identifier: MIT
// WebAssembly without threads leaves this file out.
#include "threads/has_threads.h"

#ifdef KDM_HAS_THREADS
#include "threads/thread_pool.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <system_error>
#include <utility>

#ifdef __EMSCRIPTEN__
#include <emscripten/em_macros.h>
#endif

namespace kdm {

ThreadPool::~ThreadPool() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  begun_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

bool ThreadPool::run(std::size_t tasks, int threads, const Work& work) {
  const std::unique_lock only(running_, std::try_to_lock);
  if (!only) return false;
  threads = static_cast<int>(std::min(static_cast<std::size_t>(threads), tasks));
  start_threads(threads);
  {
    const std::lock_guard lock(mutex_);
    work_ = &work;
    tasks_ = tasks;
    next_ = 0;
    failure_ = nullptr;
    helpers_ = busy_ = std::min(threads - 1, static_cast<int>(threads_.size()));
    ++jobs_;
  }
  begun_.notify_all();
  do_tasks(0);
  wait_for_helpers();
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  return true;
}

#ifdef __EMSCRIPTEN__

// Not 0 once a trap has ended a thread. Only JavaScript sees that, and sets this; a call that waits
// for the thread then ends in a trap, too.
static std::atomic<int> lost_threads = 0;

extern "C" EMSCRIPTEN_KEEPALIVE void* kdm_lost_threads() { return &lost_threads; }

void ThreadPool::wait_for_helpers() {
  std::unique_lock lock(mutex_);
  while (!ended_.wait_for(lock, std::chrono::milliseconds(100), [&] { return busy_ == 0; })) {
    if (lost_threads != 0) std::abort();
  }
}

#else

void ThreadPool::wait_for_helpers() {
  std::unique_lock lock(mutex_);
  ended_.wait(lock, [&] { return busy_ == 0; });
}

#endif

// Where the machine gives no more threads, those that there are do the work.
void ThreadPool::start_threads(int threads) {
  try {
    while (static_cast<int>(threads_.size()) < threads - 1) {
      threads_.emplace_back(&ThreadPool::wait_for_jobs, this,
                            static_cast<int>(threads_.size()) + 1);
    }
  } catch (const std::system_error&) {
    return;
  }
}

void ThreadPool::wait_for_jobs(int worker) {
  std::size_t seen = 0;
  std::unique_lock lock(mutex_);
  for (;;) {
    begun_.wait(lock, [&] { return closing_ || jobs_ != seen; });
    if (closing_) return;
    seen = jobs_;
    if (worker > helpers_) continue;
    lock.unlock();
    do_tasks(worker);
    lock.lock();
    if (--busy_ == 0) ended_.notify_one();
  }
}

void ThreadPool::do_tasks(int worker) {
  for (std::size_t task = next_++; task < tasks_; task = next_++) {
    try {
      (*work_)(task, worker);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_ || task < failed_task_) {
        failure_ = std::current_exception();
        failed_task_ = task;
      }
      next_ = tasks_;
    }
  }
}

}  // namespace kdm
#endif
