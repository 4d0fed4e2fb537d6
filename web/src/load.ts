// SPDX-License-Identifier: MIT
// The library on the calling thread, and the compiled module that it shares with the workers.
import { instantiate } from './instantiate.js';
// Not fetched later on its own: workers in the form of classic scripts cannot.
import createModule from './kdmanifold.js';
import { KdManifold } from './library.js';
import { checkSource, type LoadOptions } from './load-options.js';
import { compileFile } from './wasm-file.js';

let compiled: Promise<WebAssembly.Module> | undefined;
let loaded: Promise<KdManifold> | undefined;
let current: KdManifold | undefined;

/**
 * Loads the library onto the calling thread. The first call decides where from; later ones give the
 * same object, until `close`.
 *
 * @param options - where the WebAssembly file comes from, if not from beside the package's files
 * @returns the library; its functions are done when they return
 * @throws {@link KdManifoldError} with `LOAD_FAILED`, whose message says what to do; the next call tries again
 *
 * @example
 * ```js
 * import { load } from 'kdmanifold';
 *
 * const kdm = await load();
 * const mesh = kdm.parseMesh('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n', 'obj');
 * console.log(kdm.describe(mesh).boundaryEdges); // 3
 * ```
 */
export async function load(options: LoadOptions = {}): Promise<KdManifold> {
  const source = checkSource(options);
  if (current?.broken) loaded = current = undefined;
  loaded ??= start(source).catch((error: unknown) => {
    loaded = undefined;
    throw error;
  });
  return loaded;
}

async function start(source: LoadOptions): Promise<KdManifold> {
  const module = await compile(source);
  current = KdManifold.of(await instantiate(createModule, module));
  return current;
}

/** @internal Compiles the module, once; workers are given the result. */
export function compile(source: LoadOptions): Promise<WebAssembly.Module> {
  const compiling = (compiled ??= compileFile(source));
  compiling.catch(() => {
    if (compiled === compiling) compiled = undefined;
  });
  return compiling;
}

/** @internal Forgets the instance and the compiled module, so that their memory is given back once nobody holds them. */
export function unload(): void {
  compiled = loaded = current = undefined;
}
