// SPDX-License-Identifier: MIT
// Finds out where the code runs. Nothing is found out while the package is imported.

import type { Address } from './outside-types.js';

// Not by its bare name, for which some bundlers would put something in place.
const processOf = (): NodeJS.Process | undefined =>
  (globalThis as { process?: NodeJS.Process }).process;

/** Says whether this is Node or something that passes for it; Electron's pages and web workers count as browsers. */
export function isNode(): boolean {
  const known = processOf();
  if (typeof known?.versions?.node !== 'string') return false;
  const { type } = known as { type?: string };
  return type === undefined || type === 'browser' || type === 'utility';
}

/** Node's working directory. */
export const workingDirectory = (): string => (processOf() as NodeJS.Process).cwd();

/** Gives a module of Node's own. */
export async function nodeModule<T>(name: string): Promise<T> {
  const specifier = `node:${name}`;
  const { getBuiltinModule } = processOf() as { getBuiltinModule?: (name: string) => unknown };
  // Not in Node before 20.16. The comments keep bundlers from following the import.
  return (getBuiltinModule?.(specifier) ??
    (await import(
      /* webpackIgnore: true */ /* turbopackIgnore: true */ /* @vite-ignore */ specifier
    ))) as T;
}

/** Makes an address that a caller gives whole: a relative one is relative to the page, in Node to the working directory. */
export async function resolveAddress(address: Address): Promise<URL> {
  return new URL(textOf(address), await baseAddress());
}

/** The address as text. */
export const textOf = (address: Address): string =>
  typeof address === 'string' ? address : address.href;

async function baseAddress(): Promise<string | undefined> {
  if (isNode()) {
    const { pathToFileURL } = await nodeModule<typeof import('node:url')>('url');
    return `${pathToFileURL(workingDirectory()).href}/`;
  }
  const { document, location } = globalThis as { document?: Document; location?: Location };
  return document?.baseURI ?? location?.href;
}
