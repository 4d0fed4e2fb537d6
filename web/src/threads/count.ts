// SPDX-License-Identifier: MIT
// How many threads share the work.
import { isNode, nodeModule } from '../environment.js';
import type { Source } from '../load-options.js';

// More are started only where they are asked for: each takes time and memory before there is work for it.
const most = 16;

/**
 * @internal Returns how many threads an instance is to have. `here`: on the calling thread, which the work blocks; a
 * page's own must not be. Who says where kdmanifold.wasm comes from gets what that file has: one.
 */
export async function threadsFor(source: Source, here = false): Promise<number> {
  const { threads, concurrency, wasmBinary, wasmUrl } = source;
  if (threads === 1 || wasmBinary !== undefined || wasmUrl !== undefined) return 1;
  if (!(isNode() || isIsolated(here))) return 1;
  return threads ?? Math.max(1, Math.floor(Math.min(most, await machineThreads()) / concurrency));
}

/** Says whether a browser allows memory that threads share, and waiting for them. */
function isIsolated(here: boolean): boolean {
  const { crossOriginIsolated, document } = globalThis as {
    crossOriginIsolated?: boolean;
    document?: Document;
  };
  return crossOriginIsolated === true && !(here && document !== undefined);
}

async function machineThreads(): Promise<number> {
  if (!isNode()) return globalThis.navigator.hardwareConcurrency;
  return (await nodeModule<typeof import('node:os')>('os')).availableParallelism();
}
