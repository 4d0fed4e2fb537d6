// SPDX-License-Identifier: MIT
// The operands of Boolean operations, as src/cli/solids.cpp reads and joins them, word for word.
import { readAll } from './files.js';
import { standardStream } from './formats.js';
import { usageError, type Command, type RepeatedArgument } from './options.js';
import { KdManifoldError } from '../errors.js';
import type { BooleanExpression } from '../expression.js';
import type { Grid } from '../grid.js';
import type { RawMade } from '../kdmanifold.js';
import type { KdManifold } from '../library.js';
import { signedNumber } from '../option-spec.js';
import { checkSolids } from '../solids.js';
import type { StepOptions } from '../steps.js';
import type { MeshInput, ProgressCallback } from '../types.js';

/** One operand: INPUT, or the file of an operation. */
export interface SolidFile {
  path: string;
  transform: number[] | null;
  /** What joins it to all before it; of INPUT nothing. */
  operation?: string;
}

/**
 * Returns INPUT, which is called `input`, and the files of the operations in their order. Throws if a transform is no
 * transform, or if an operand has two.
 */
export function readSolids({ solids }: Command, input = ''): SolidFile[] {
  const refuse = ({ typed }: RepeatedArgument, text: string): never =>
    usageError(`${typed}: ${text}`);
  let file: SolidFile = { path: input, transform: null };
  const files = [file];
  for (const argument of solids) {
    const { flag, value } = argument;
    if (flag === '--transform') {
      if (file.transform !== null) refuse(argument, 'is given twice for one operand');
      file.transform =
        transformOf(value) ??
        refuse(
          argument,
          `'${value}' is no transform: 12 numbers with commas between them, three rows of four, ` +
            'or 16 with 0,0,0,1 at the end',
        );
      continue;
    }
    if (value === standardStream) refuse(argument, 'it cannot be read from a stream');
    file = { path: value, transform: null, operation: flag };
    files.push(file);
  }
  return files;
}

// Reads the rows of a matrix, and returns its columns; null if it is none.
function transformOf(text: string): number[] | null {
  const numbers = text.split(',').map(signedNumber);
  if (numbers.length === 12) numbers.push(0, 0, 0, 1);
  const last = numbers.slice(12).join();
  if (numbers.length !== 16 || !numbers.every(Number.isFinite) || last !== '0,0,0,1') return null;
  return numbers.map((_, i) => numbers[4 * (i % 4) + Math.floor(i / 4)] as number);
}

const operations = {
  '--union': 'union',
  '--intersection': 'intersection',
  '--difference': 'difference',
  '--symmetric-difference': 'symmetricDifference',
} as const;

/** Merges the grid in INPUT with those of the operations, from left to right. Errors begin with the file at fault. */
export async function mergeGrids(
  library: KdManifold,
  { solids }: Command,
  input: string,
  onProgress: ProgressCallback,
): Promise<Grid> {
  const grids: Grid[] = [];
  try {
    for (const path of [input, ...solids.map(({ value }) => value)]) {
      grids.push(library.loadGrid(await readAll(path), path));
    }
    for (const [i, { flag, value }] of solids.entries()) {
      const [merged, other] = [grids[0], grids[i + 1]] as [Grid, Grid];
      try {
        grids[0] = merged.merge(other, operations[flag as keyof typeof operations], {
          onProgress: (fraction, phase) => onProgress((i + fraction) / solids.length, phase),
        });
      } catch (error) {
        if (!(error instanceof KdManifoldError)) throw error;
        throw new KdManifoldError(error.code, `${value}: ${error.message}`);
      }
      merged.delete();
    }
    return grids.shift() as Grid;
  } finally {
    for (const grid of grids) grid.delete();
  }
}

/**
 * Makes what the operations say, which are done from left to right. Errors of an operand begin with its
 * file.
 */
export function makeSolids(
  library: KdManifold,
  { build, extract, reduction }: Command,
  files: SolidFile[],
  scenes: { mesh: MeshInput }[],
  steps: StepOptions,
): RawMade & { grid: Grid } {
  let whole: BooleanExpression = 0;
  files.forEach(({ operation }, i) => {
    if (operation === undefined) return;
    whole = [operations[operation as keyof typeof operations], whole, i];
  });
  try {
    const solids = checkSolids(
      whole,
      scenes.map(({ mesh }) => mesh),
      { transforms: files.map(({ transform }) => transform) },
    );
    return library.makeSolids(solids, { ...build, ...extract, ...reduction }, {}, steps);
  } catch (error) {
    const [, number, rest] =
      /^operand (\d+): (.*)$/s.exec(error instanceof KdManifoldError ? error.message : '') ?? [];
    const path = files[Number(number)]?.path;
    if (!(error instanceof KdManifoldError) || path === undefined) throw error;
    throw new KdManifoldError(error.code, `${path}: ${rest}`);
  }
}
