// SPDX-License-Identifier: MIT
// The main module, compiled: with one thread, or with several.
import { instantiate } from './instantiate.js';
import createModule from './kdmanifold.js';
import { KdManifold } from './library.js';

/** @internal A compiled module, which workers can be sent. */
export interface Artefact {
  module: WebAssembly.Module;
  threads: number;
  /** Where kdmanifold-threads.js lies; null: one thread needs nothing but what is here. */
  glue: string | null;
}

/** @internal Starts an instance on the calling thread. */
export async function open({ module, threads, glue }: Artefact): Promise<KdManifold> {
  if (glue === null) return KdManifold.of(await instantiate(createModule, module));
  const { startThreads } = (await import(
    /* webpackIgnore: true */ /* turbopackIgnore: true */ /* @vite-ignore */ glue
  )) as typeof import('./threads/module.js');
  const { raw, end } = await startThreads(module, threads);
  return KdManifold.of(raw, threads, end);
}
