// SPDX-License-Identifier: MIT
// How many threads the library works with.
#pragma once

namespace kdm {

/// The most threads that can be asked for.
inline constexpr int kMostThreads = 256;

/// Sets how many threads the calls of this library share their work among, 1 to 256; 0 stands for
/// as many as the machine runs at once, which is what holds as long as nothing is set. It holds for
/// the whole process and for calls that begin later. What comes out is the same, byte for byte,
/// with any number. Callbacks, such as those for progress, run on the calling thread only. Of two
/// calls at the same time one may have to do with its own thread. In WebAssembly without
/// threads there is one, whatever is set. Throws `kInvalidOption`.
void set_thread_count(int count);

/// Returns how many threads calls work with: what was set, or what the machine runs at once.
int thread_count();

}  // namespace kdm
