// SPDX-License-Identifier: MIT
// The library on the calling thread, and the compiled module that it shares with the workers.
import { open, type Artefact } from './artefact.js';
import { instantiate } from './instantiate.js';
// Not fetched later on its own: workers in the form of classic scripts cannot.
import createTools from './kdmanifold-tools.js';
import type { KdManifold } from './library.js';
import { checkSource, type LoadOptions, type Source } from './load-options.js';
import { threadsFor } from './threads/count.js';
import { addressOf, compileFile, type WasmFile } from './wasm-file.js';

const compiled = new Map<WasmFile, Promise<WebAssembly.Module>>();
let loaded: Promise<KdManifold> | undefined;
let current: KdManifold | undefined;

/**
 * Loads the library onto the calling thread. The first call decides where from, and with how many
 * threads; later ones give the same object, until `close`.
 *
 * @param options - where the WebAssembly files come from, if not from beside the package's files; how many threads share
 * the work
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
  const [library, tools] = await Promise.all([
    loadMain(source),
    source.tools ? compileTools(source) : undefined,
  ]);
  if (tools === undefined || library.hasTools) return library;
  if (tools instanceof Error) library.lackTools(tools);
  else library.takeTools(await instantiate(createTools, tools));
  return library;
}

/** @internal The same without file formats and `analyze`. */
export function loadMain(source: Source): Promise<KdManifold> {
  if (current?.broken) loaded = current = undefined;
  loaded ??= start(source).catch((error: unknown) => {
    loaded = undefined;
    throw error;
  });
  return loaded;
}

async function start(source: Source): Promise<KdManifold> {
  const artefact = await compile(source, await threadsFor(source, true));
  current = await open(artefact).catch(async (error: unknown) => {
    if (artefact.threads === 1) throw error;
    return open(await compile(source, 1));
  });
  return current;
}

/**
 * @internal Compiles the main module, once; workers are given the result. Where the one with several threads cannot be
 * had, as where a bundler has not followed, it is the other, which does the same.
 */
export async function compile(source: LoadOptions, threads: number): Promise<Artefact> {
  if (threads > 1) {
    try {
      const [module, { href }] = await Promise.all([
        compileOnce('kdmanifold-threads.wasm', source),
        addressOf('kdmanifold-threads.js', source),
      ]);
      return { module, threads, glue: href };
    } catch {
      // Below.
    }
  }
  return { module: await compileOnce('kdmanifold.wasm', source), threads: 1, glue: null };
}

/** The module of tools, or why there is none: who converts only can do without. */
const compileTools = (source: LoadOptions): Promise<WebAssembly.Module | Error> =>
  compileOnce('kdmanifold-tools.wasm', source).catch((error: unknown) => error as Error);

function compileOnce(file: WasmFile, source: LoadOptions): Promise<WebAssembly.Module> {
  let compiling = compiled.get(file);
  if (compiling === undefined) {
    compiling = compileFile(file, source);
    compiled.set(file, compiling);
    compiling.catch(() => compiled.delete(file));
  }
  return compiling;
}

/** @internal Forgets instances and compiled modules, so that their memory is given back once nobody holds them. */
export function unload(): void {
  compiled.clear();
  loaded = current = undefined;
}
