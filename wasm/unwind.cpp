// SPDX-License-Identifier: MIT
// Emscripten's own file of how exceptions are caught, with one variable for all threads: see
// CMakeLists.txt.
#include <config.h>
#include <stdbool.h>
#include <threads.h>
#include <unwind.h>

#define thread_local

extern "C" {
#include <Unwind-wasm.c>
}
