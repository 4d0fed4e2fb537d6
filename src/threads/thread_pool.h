// SPDX-License-Identifier: MIT
// Threads that wait for work between one call and the next.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace kdm {

/// Runs the tasks of one job at a time. Threads are made when they are first wanted, and kept.
class ThreadPool {
 public:
  using Work = std::function<void(std::size_t task, int worker)>;

  ThreadPool() = default;
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;
  ~ThreadPool();

  /// Shares tasks among the calling thread and up to `threads` - 1 others (see `share_work`).
  /// Returns false, and does nothing, while another thread has its work shared.
  bool run(std::size_t tasks, int threads, const Work& work);

 private:
  void start_threads(int threads);
  void wait_for_helpers();
  void wait_for_jobs(int worker);
  void do_tasks(int worker);

  std::mutex running_;  // held by the thread that has its work shared
  std::mutex mutex_;    // guards what follows up to `threads_`
  std::condition_variable begun_;
  std::condition_variable ended_;
  std::size_t jobs_ = 0;  // begun so far
  int helpers_ = 0;       // of the job at hand
  int busy_ = 0;          // helpers that have not ended the job at hand
  bool closing_ = false;
  std::exception_ptr failure_;
  std::size_t failed_task_ = 0;
  std::vector<std::thread> threads_;
  // The job at hand.
  const Work* work_ = nullptr;
  std::size_t tasks_ = 0;
  std::atomic<std::size_t> next_ = 0;
};

}  // namespace kdm
