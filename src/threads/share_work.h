// SPDX-License-Identifier: MIT
// Tasks that threads share. Steps of the method use it for parts that do not depend on each other,
// and put what the parts found together in the order of the parts, so that nothing depends on the
// number of threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

#include "threads/has_threads.h"

namespace kdm {

/// Returns how many threads are to share work if it is shared here: 1 within a task.
int workers();

/// Calls `work(task, worker)` for each task from 0 to `tasks` - 1, on up to `threads` threads, and
/// returns when all are done. Tasks begin in their order. `worker` is a number below `threads` that
/// no two tasks have at the same time; 0 is always the calling thread. If a task throws, no more
/// tasks begin, and of those that threw the first one's exception is thrown again. Within a task
/// of another call, all is done on the thread at hand. Whoever has something ready for each worker
/// says for how many: `workers()` may have changed since.
void share_work(std::size_t tasks, int threads,
                const std::function<void(std::size_t task, int worker)>& work);

/// Returns the first number of a part, if `count` things are divided into so many parts of about
/// equal size, numbered from 0. The first number of the part after the last is `count`.
inline std::size_t begin_of_part(std::size_t count, std::size_t part, std::size_t parts) {
  return count / parts * part + count % parts * part / parts;
}

/// Calls `work(begin, end)` for parts of `count` things, `size` each but for the last, on several
/// threads. The parts are the same with any number of threads.
template <typename Work>
void share_parts(std::size_t count, std::size_t size, const Work& work) {
  const auto do_part = [&](std::size_t part, int) {
    work(part * size, std::min(count, (part + 1) * size));
  };
  const std::size_t parts = (count + size - 1) / size;
  if constexpr (kHasThreads) {
    share_work(parts, workers(), do_part);
  } else {
    for (std::size_t part = 0; part < parts; ++part) do_part(part, 0);
  }
}

}  // namespace kdm
