// SPDX-License-Identifier: MIT
// The operands of Boolean operations, as src/cli/solids.cpp reads and joins them, word for word.
import { standardStream } from './formats.js';
import { usageError, type Command, type RepeatedArgument } from './options.js';
import { KdManifoldError } from '../errors.js';
import type { BooleanExpression } from '../expression.js';
import type { Grid } from '../grid.js';
import type { RawMade } from '../kdmanifold.js';
import { namesAGrid, type KdManifold } from '../library.js';
import { checkSolids } from '../solids.js';
import type { StepOptions } from '../steps.js';
import type { MeshInput } from '../types.js';

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
    if (namesAGrid(value)) refuse(argument, `${value} is a grid, but operands are meshes`);
    file = { path: value, transform: null, operation: flag };
    files.push(file);
  }
  return files;
}

// Reads the rows of a matrix, and returns its columns; null if it is none.
function transformOf(text: string): number[] | null {
  const numbers = text
    .split(',')
    .map((one) => (/^-?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(one) ? Number(one) : NaN));
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
