// SPDX-License-Identifier: MIT
// Where the package's files lie when a tool has moved the code that asks away from them.
import { nodeModule, workingDirectory } from './environment.js';

// Not written into the expressions below, in which bundlers would see files to be copied.
const here = (): string => import.meta.url;

/**
 * @internal The address of a file of the package in a browser, or null where it is simply beside this one. Vite's
 * development server puts copies of packages, without their files, into node_modules/.vite/.
 */
export function movedAddress(name: string): string | null {
  const moved = /^(.*)\/\.vite\/(?:.*\/)?deps[^/]*\/[^/]*$/.exec(here());
  return moved ? `${moved[1]}/kdmanifold/dist/${name}` : null;
}

/** @internal The address of the file beside this one. */
export const neighbour = (name: string): URL => new URL(`./${name}`, here());

/**
 * @internal The address of a file of the package in Node: beside this one, or, where this one is a part of a bundle,
 * in the package that is installed where the program runs.
 */
export async function nodeAddress(name: string): Promise<URL> {
  const [{ existsSync }, { pathToFileURL }, { createRequire }] = await Promise.all([
    nodeModule<typeof import('node:fs')>('fs'),
    nodeModule<typeof import('node:url')>('url'),
    nodeModule<typeof import('node:module')>('module'),
  ]);
  const beside = /^file:/.test(here()) ? neighbour(name) : null;
  if (beside && existsSync(beside)) return beside;
  try {
    const installed = createRequire(`${workingDirectory()}/`).resolve('kdmanifold/package.json');
    return new URL(`dist/${name}`, pathToFileURL(installed));
  } catch {
    throw new Error(
      `${name} lies neither beside the bundle nor in the package kdmanifold of ${workingDirectory()}: leave ` +
        `the package out of the bundle (Next: serverExternalPackages: ['kdmanifold'])`,
    );
  }
}
