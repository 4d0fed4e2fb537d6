// SPDX-License-Identifier: MIT
// The number of threads that a test works with.
#pragma once

#include "kdmanifold/threads.h"

namespace kdm {

/// Sets how many threads work as long as it lives.
class ThreadCount {
 public:
  explicit ThreadCount(int count) { set_thread_count(count); }
  ThreadCount(const ThreadCount&) = delete;
  ThreadCount& operator=(const ThreadCount&) = delete;
  ~ThreadCount() { set_thread_count(0); }
};

}  // namespace kdm
