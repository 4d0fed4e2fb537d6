// SPDX-License-Identifier: MIT
// Where the package's files come from, and who works.
import { KdManifoldError } from './errors.js';
import type { Address, CompiledModule, WorkerLike } from './outside-types.js';
import { pick } from './pick.js';

/** Where the WebAssembly files come from, if not from beside the package's own files. */
export interface LoadOptions {
  /** The content of `kdmanifold.wasm`, or the compiled module. */
  wasmBinary?: ArrayBuffer | ArrayBufferView | CompiledModule;
  /**
   * The address of `kdmanifold.wasm`, for instance as a bundler or a content delivery network has it.
   * A relative one is relative to the page, in Node to the working directory.
   */
  wasmUrl?: Address;
  /** The content of `kdmanifold-tools.wasm`, which has file formats and `analyze`, or the compiled module. */
  toolsWasmBinary?: ArrayBuffer | ArrayBufferView | CompiledModule;
  /** The address of `kdmanifold-tools.wasm`. */
  toolsWasmUrl?: Address;
  /**
   * `load`: whether to fetch the tools, too. True, the default: they are there, or calling them says why not;
   * `makeManifold` never needs them.
   */
  tools?: boolean;
  /**
   * How many threads share the work of one call, a whole number from 1 to 256; the result is the same with any number.
   * The default is as many as the machine runs at once, but no more than 16, divided by `concurrency`. Where threads
   * cannot share memory there is one: pages that are not cross-origin isolated, `load` on a page's own thread, and
   * where `wasmUrl` or `wasmBinary` is given. `report.threads` says how many there were.
   */
  threads?: number;
}

/** Where conversions are done. */
export interface WorkerOptions {
  /** The address of `kdmanifold-worker.js`, if it does not lie beside the package's own files; of another origin, too. */
  workerUrl?: Address;
  /**
   * A worker that runs `kdmanifold/worker`, or a function that starts one, for bundlers that want it so;
   * false: the calling thread does the work, and can do nothing else meanwhile.
   */
  worker?: WorkerLike | (() => WorkerLike) | false;
  /** How many conversions may be done at a time, each in a worker with memory of its own: a whole number from 1, the default, to 64. */
  concurrency?: number;
}

/** The names of these options. */
export const sourceKeys = [
  'wasmBinary',
  'wasmUrl',
  'toolsWasmBinary',
  'toolsWasmUrl',
  'tools',
  'threads',
  'workerUrl',
  'worker',
  'concurrency',
] as const;

/** @internal All of them, checked. */
export type Source = LoadOptions & WorkerOptions & { concurrency: number; tools: boolean };

const refuse = (name: string, expected: string): never => {
  throw new KdManifoldError('INVALID_OPTION', `${name}: expected ${expected}`);
};

const isAddress = (value: unknown): boolean =>
  typeof value === 'string' || typeof (value as { href?: unknown } | null)?.href === 'string';

/** @internal Checks and returns the options that say where from. */
export function checkSource(options: LoadOptions & WorkerOptions): Source {
  const { worker, concurrency = 1, tools = true, threads } = options;
  for (const name of ['wasmUrl', 'toolsWasmUrl', 'workerUrl'] as const) {
    const value = options[name];
    if (value !== undefined && !isAddress(value)) refuse(name, 'a string or a URL');
  }
  for (const name of ['wasmBinary', 'toolsWasmBinary'] as const) {
    const value = options[name];
    if (value !== undefined && !isBinary(value)) {
      refuse(name, 'an ArrayBuffer, a typed array or a WebAssembly.Module');
    }
  }
  if (typeof tools !== 'boolean') refuse('tools', 'true or false');
  if (worker !== undefined && worker !== false && !isWorker(worker)) {
    refuse('worker', 'a Worker, a function that starts one, or false');
  }
  checkCount('concurrency', concurrency, 64);
  if (threads !== undefined) checkCount('threads', threads, 256);
  if (concurrency > 1 && typeof worker === 'object') {
    refuse('worker', `a function that starts workers, as concurrency is ${concurrency}`);
  }
  return { ...pick(options, sourceKeys), tools, concurrency };
}

function checkCount(name: string, value: number, most: number): void {
  if (!Number.isInteger(value) || value < 1 || value > most) {
    refuse(name, `a whole number from 1 to ${most}, got ${String(value)}`);
  }
}

function isBinary(value: unknown): boolean {
  const kind = Object.prototype.toString.call(value);
  return ArrayBuffer.isView(value) || /ArrayBuffer\]$|WebAssembly.Module\]$/.test(kind);
}

function isWorker(value: unknown): boolean {
  if (typeof value === 'function') return true;
  return typeof (value as { postMessage?: unknown } | null)?.postMessage === 'function';
}
