// SPDX-License-Identifier: MIT
// The types of what Emscripten generates from wasm/bindings.cpp with threads. Only threads/module.ts sees them.
import type { CreateModule, RawModule } from './kdmanifold.js';

export interface RawThreadsModule extends RawModule {
  setThreadCount(count: number): void;
  /** The address of a 32-bit number, which is to be set once a thread has ended by a trap: calls do not wait for it. */
  _kdm_lost_threads(): number;
}

declare const createModule: CreateModule<RawThreadsModule>;
export default createModule;
