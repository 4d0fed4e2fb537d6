// SPDX-License-Identifier: MIT
// Finds out where the code runs. Nothing is found out while the package is imported.

/** Says whether this is Node or something that passes for it; Electron's pages count as browsers. */
export function isNode(): boolean {
  return (
    typeof process === 'object' &&
    typeof process.versions?.node === 'string' &&
    (process as { type?: string }).type !== 'renderer'
  );
}

/** Imports a module of Node's own. The name is put together here so that no bundler tries to follow it. */
export function nodeModule<T>(name: string): Promise<T> {
  const specifier = `node:${name}`;
  return import(/* @vite-ignore */ /* webpackIgnore: true */ specifier) as Promise<T>;
}
