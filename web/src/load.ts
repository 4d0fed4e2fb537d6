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
 * same object, until `close`. If it fails (`LOAD_FAILED`) the next call tries again.
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
