// SPDX-License-Identifier: MIT
// The formats of files that command lines read and write: those of the library, and GLB.
import { nearest } from './suggest.js';
import { KdManifoldError } from '../errors.js';
import type { MeshFormat } from '../types.js';

/** What a file is. */
export type FileFormat = MeshFormat | 'glb';

const formats: readonly string[] = ['obj', 'stl', 'ply', 'off', 'glb'] satisfies FileFormat[];

/** Standard input or standard output, as a path. */
export const standardStream = '-';

/** Returns what messages call a file. */
export const inputName = (path: string): string =>
  path === standardStream ? 'standard input' : path;

/** Returns the last part of a path, without its folder. */
export const fileName = (path: string): string => path.slice(path.search(/[^/\\]*$/));

// In lower case, without its dot; empty: there is none.
const extensionOf = (path: string): string =>
  (/\.([^.]*)$/.exec(fileName(path))?.[1] ?? '').replace(/[A-Z]/g, (c) => c.toLowerCase());

function hint(extension: string, option: string): string {
  if (extension === 'gltf') return '; .gltf files are not supported, .glb files are';
  if (extension === 'kdgrid') return '; --save-grid keeps grids';
  const near = nearest(extension, formats);
  if (near !== undefined) return `; did you mean .${near}?`;
  return `; ${option} tells the format of other names`;
}

function formatOf(
  path: string,
  chosen: FileFormat | undefined,
  stream: string,
  option: string,
): FileFormat {
  if (chosen !== undefined) return chosen;
  if (path === standardStream) {
    throw new KdManifoldError(
      'IO_ERROR',
      `${stream} has no name that tells its format; ${option} does`,
    );
  }
  const extension = extensionOf(path);
  if (formats.includes(extension)) return extension as FileFormat;
  throw new KdManifoldError(
    'IO_ERROR',
    `${path}: the file's name ends in none of .obj, .stl, .ply, .off and .glb${hint(extension, option)}`,
  );
}

/** Returns the format of an input: `chosen`, or else what the extension (any case) stands for. */
export const inputFormat = (path: string, chosen: FileFormat | undefined): FileFormat =>
  formatOf(path, chosen, 'standard input', '--input-format');

/** Returns the format of a result. See above. */
export const outputFormat = (path: string, chosen: FileFormat | undefined): FileFormat =>
  formatOf(path, chosen, 'standard output', '--format');
