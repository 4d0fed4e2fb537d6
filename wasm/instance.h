// SPDX-License-Identifier: MIT
// What every module says about itself.
#pragma once

#include <malloc.h>

#include <emscripten/heap.h>
#include <emscripten/val.h>

#include <string>

#include "kdmanifold/kdmanifold.h"

namespace kdm::wasm {

/// Returns the bytes of the heap, which never shrinks (so it is the most that was ever needed), and
/// the bytes in use.
inline emscripten::val memory() {
  emscripten::val to = emscripten::val::object();
  to.set("heapBytes", emscripten_get_heap_size());
  to.set("usedBytes", static_cast<std::size_t>(mallinfo().uordblks));
  return to;
}

inline std::string version() { return KDM_VERSION; }

}  // namespace kdm::wasm
