// SPDX-License-Identifier: MIT
// Put among Emscripten's own functions: no warning of calls that wait for threads. The wrapper makes none on a page's
// own thread, and Node's may wait.
mergeInto(LibraryManager.library, { emscripten_check_blocking_allowed: function () {} });
