// SPDX-License-Identifier: MIT
// Finds, compiles and starts the WebAssembly file, once.
import { isNode, nodeModule } from './environment.js';
import { KdManifoldError } from './errors.js';
import createModule from './kdmanifold.js';
import { KdManifold } from './library.js';

/** Where the WebAssembly file comes from, if not from beside the package's own files. */
export interface LoadOptions {
  /** Its content, or the compiled module. */
  wasmBinary?: BufferSource | WebAssembly.Module;
  /** Its address, for instance as a bundler or a content delivery network has it. */
  wasmUrl?: string | URL;
}

let compiled: Promise<WebAssembly.Module> | undefined;
let loaded: Promise<KdManifold> | undefined;
let current: KdManifold | undefined;

/**
 * Loads the library. The first call decides where from; later ones give the same object. If it
 * fails (`LOAD_FAILED`) the next call tries again.
 */
export function load(options: LoadOptions = {}): Promise<KdManifold> {
  if (current?.broken) loaded = current = undefined;
  loaded ??= compile(options)
    .then(instantiate)
    .then((library) => (current = library))
    .catch((error: unknown) => {
      loaded = undefined;
      throw error;
    });
  return loaded;
}

/** @internal Compiles the module, once; workers are given the result. */
export function compile(options: LoadOptions = {}): Promise<WebAssembly.Module> {
  compiled ??= compileFrom(options).catch((error: unknown) => {
    compiled = undefined;
    throw new KdManifoldError('LOAD_FAILED', `kdmanifold.wasm: ${String(error)}`, { cause: error });
  });
  return compiled;
}

/** @internal Starts an instance of a compiled module, with memory of its own. */
export async function instantiate(module: WebAssembly.Module): Promise<KdManifold> {
  const raw = await new Promise<Awaited<ReturnType<typeof createModule>>>((resolve, reject) => {
    createModule({
      instantiateWasm(imports, receive) {
        WebAssembly.instantiate(module, imports).then(
          (instance) => receive(instance, module),
          reject,
        );
        return {};
      },
    }).then(resolve, reject);
  });
  return KdManifold.of(raw);
}

async function compileFrom({ wasmBinary, wasmUrl }: LoadOptions): Promise<WebAssembly.Module> {
  if (wasmBinary instanceof WebAssembly.Module) return wasmBinary;
  if (wasmBinary !== undefined) return WebAssembly.compile(wasmBinary);
  // The one place that says where the file is; bundlers recognise this very form.
  const url = new URL(wasmUrl ?? new URL('./kdmanifold.wasm', import.meta.url), import.meta.url);
  if (isNode() && url.protocol === 'file:') {
    const { readFile } = await nodeModule<typeof import('node:fs/promises')>('fs/promises');
    return WebAssembly.compile(await readFile(url));
  }
  const response = await fetch(url, { credentials: 'same-origin' });
  if (!response.ok) throw new Error(`${url.href} answered ${response.status}`);
  // Streaming compiles while loading, but demands the right type from the server.
  return response.headers.get('content-type')?.startsWith('application/wasm')
    ? WebAssembly.compileStreaming(response)
    : WebAssembly.compile(await response.arrayBuffer());
}
