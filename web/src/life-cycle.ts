// SPDX-License-Identifier: MIT
// What comes before the first conversion and after the last.
import { checkSource, sourceKeys, type LoadOptions, type WorkerOptions } from './load-options.js';
import { KdManifoldError } from './errors.js';
import { shutDown, warmUp } from './worker/pool.js';

/** Where from, and how many workers, for `preload`. */
export interface PreloadOptions extends LoadOptions, WorkerOptions {}

/**
 * Fetches and compiles the WebAssembly file and starts as many workers as `concurrency` says, so that the
 * first `makeManifold` finds them ready. Resolves when they are.
 */
export async function preload(options: PreloadOptions = {}): Promise<void> {
  for (const name of Object.keys(options)) {
    if (!(sourceKeys as readonly string[]).includes(name)) {
      throw new KdManifoldError('INVALID_OPTION', `${name}: no such option`);
    }
  }
  await warmUp(checkSource(options));
}

/**
 * Ends all workers and gives their memory back. Conversions that are under way reject with `ABORTED`.
 * What `load` gave stays usable, but is no longer kept; the next call of anything starts anew.
 */
export async function close(): Promise<void> {
  await shutDown();
}
