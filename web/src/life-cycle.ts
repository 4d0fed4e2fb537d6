// SPDX-License-Identifier: MIT
// What comes before the first conversion and after the last.
import { checkSource, sourceKeys, type LoadOptions, type WorkerOptions } from './load-options.js';
import { KdManifoldError } from './errors.js';
import { closeScenes } from './open-boolean-scene.js';
import { shutDown, warmUp } from './worker/pool.js';

/** Where from, and how many workers, for `preload`. */
export interface PreloadOptions extends LoadOptions, WorkerOptions {}

/**
 * Fetches and compiles the WebAssembly file and starts as many workers as `concurrency` says, so that the
 * first `makeManifold` finds them ready. Resolves when they are.
 *
 * @param options - where from, and how many workers
 * @throws {@link KdManifoldError} with `LOAD_FAILED` or `INVALID_OPTION`
 *
 * @example
 * ```js
 * import { makeManifold, preload } from 'kdmanifold';
 *
 * const ready = preload({ concurrency: 2 }); // while the user still looks for a file
 * await ready;
 * const meshes = [{ positions, indices }, { positions, indices }];
 * await Promise.all(meshes.map((mesh) => makeManifold(mesh, { concurrency: 2 })));
 * ```
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
 * Ends all workers, closes all scenes and gives their memory back. Conversions that are under way reject with `ABORTED`.
 * What `load` gave stays usable, but is no longer kept; the next call of anything starts anew.
 *
 * @returns when the workers are gone
 *
 * @example
 * ```js
 * import { close, makeManifold } from 'kdmanifold';
 *
 * await makeManifold({ positions, indices });
 * await close(); // a page that is done with meshes for now
 * ```
 */
export async function close(): Promise<void> {
  closeScenes();
  await shutDown();
}
