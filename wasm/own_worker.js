// SPDX-License-Identifier: MIT
// Put before Emscripten's glue: threads are workers of the wrapper's own kind, in Node as well as in browsers.
const Worker = Module['Worker'];
