// SPDX-License-Identifier: MIT
// What Emscripten generates for threads: it sets `self.onmessage`, and exports nothing.
export {};
