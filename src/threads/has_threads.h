// SPDX-License-Identifier: MIT
// Whether there can be several threads at all: not in WebAssembly that is built without. What only
// several need is left out there, since pages would have to fetch it.
#pragma once

#if !defined(__EMSCRIPTEN__) || defined(__EMSCRIPTEN_PTHREADS__)
#define KDM_HAS_THREADS 1
#endif

namespace kdm {

#ifdef KDM_HAS_THREADS
inline constexpr bool kHasThreads = true;
#else
inline constexpr bool kHasThreads = false;
#endif

}  // namespace kdm
