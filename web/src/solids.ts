// SPDX-License-Identifier: MIT
// The operands of Boolean operations, and their checks.
import { checkMesh, type CheckedMesh } from './check-input.js';
import { KdManifoldError } from './errors.js';
import { postfix, type BooleanExpression, type BooleanOperation } from './expression.js';
import { buildOptions, type BuildOptions } from './options.js';
import type { MeshInput } from './types.js';

/** What Boolean operations can be told of their operands. */
export interface SolidOptions {
  /**
   * Where the operands go: one entry each, `null` for those that stay. A transform has 16 numbers, column by column,
   * as `Matrix4.elements` of three.js has them. It may mirror; it must be affine and invertible.
   */
  transforms?: readonly (ArrayLike<number> | null | undefined)[] | null;
  /** What counts as inside: one entry an operand, `null` for those of which the option `inside` says it. */
  insides?: readonly (BuildOptions['inside'] | null)[] | null;
}

/** @internal An operand, checked. */
export interface Solid extends CheckedMesh {
  transform: Float64Array | null;
  inside: string | null;
}

/** @internal What is to be joined, checked. */
export interface Solids {
  solids: Solid[];
  expression: Int32Array;
}

/** @internal The names of the options of operands. */
export const solidKeys = ['transforms', 'insides'];

/** @internal Checks operands, expression and the options of operands. Errors begin with the number of the operand. */
export function checkSolids(
  expression: BooleanOperation | BooleanExpression,
  operands: readonly MeshInput[],
  { transforms, insides }: SolidOptions,
): Solids {
  if (!Array.isArray(operands) || operands.length === 0) {
    refuse('operands: expected an array with one mesh at least');
  }
  checkLength('transforms', transforms, operands.length);
  checkLength('insides', insides, operands.length);
  const solids = operands.map((operand: MeshInput, i) => {
    try {
      return {
        ...checkMesh(operand),
        transform: checkTransform(transforms?.[i]),
        inside: checkInside(insides?.[i]),
      };
    } catch (error) {
      if (!(error instanceof KdManifoldError)) throw error;
      throw new KdManifoldError(error.code, `operand ${i}: ${error.message}`);
    }
  });
  return { solids, expression: postfix(expression, solids.length) };
}

function refuse(message: string): never {
  throw new KdManifoldError('INVALID_OPTION', message);
}

function checkLength(name: string, given: unknown, operands: number): void {
  if (given === undefined || given === null) return;
  if (!Array.isArray(given)) refuse(`${name}: expected an array`);
  if (given.length !== operands) {
    refuse(`${name}: length ${given.length}, but there are ${operands} operands`);
  }
}

/** @internal Checks the place of one of so many operands. */
export function checkPlace(
  operand: number,
  transform: ArrayLike<number> | null | undefined,
  operands: number,
): Float64Array | null {
  if (!Number.isInteger(operand) || operand < 0 || operand >= operands) {
    refuse(`operand: expected a whole number from 0 to ${operands - 1}, got ${String(operand)}`);
  }
  return checkTransform(transform);
}

function checkTransform(given: ArrayLike<number> | null | undefined): Float64Array | null {
  if (given === undefined || given === null) return null;
  if (typeof given !== 'object' || given.length !== 16) refuse('transform: expected 16 numbers');
  const numbers = Float64Array.from(given);
  const wrong = numbers.find((number) => !Number.isFinite(number));
  if (wrong !== undefined) refuse(`transform: a number of it is ${wrong}`);
  const [a, b, c, d] = [3, 7, 11, 15].map((i) => numbers[i]);
  if (a !== 0 || b !== 0 || c !== 0 || d !== 1) {
    refuse('transform: it is not affine: the numbers 3, 7, 11 and 15 must be 0, 0, 0 and 1');
  }
  return numbers;
}

function checkInside(given: string | null | undefined): string | null {
  if (given === undefined || given === null) return null;
  const { inside } = buildOptions;
  if (inside.kind === 'choice' && !inside.words.includes(given)) {
    refuse(`inside: expected one of ${inside.words.join(', ')}, got '${given}'`);
  }
  return given;
}
