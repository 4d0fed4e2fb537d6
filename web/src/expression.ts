// SPDX-License-Identifier: MIT
// Boolean expressions over operands, and how they are checked and handed to WebAssembly.
import { KdManifoldError } from './errors.js';

/** What joins operands: for three and more of them from left to right. */
export type BooleanOperation =
  'union' | 'intersection' | 'difference' | 'symmetricDifference' | 'complement';

/**
 * The number of an operand, counted from 0, or an operation and what it joins:
 * `['difference', 0, ['union', 1, 2]]`.
 */
export type BooleanExpression = number | readonly [BooleanOperation, ...BooleanExpression[]];

// As build_boolean_grid in wasm/module.h knows them.
const codes: Record<BooleanOperation, number> = {
  union: -1,
  intersection: -2,
  difference: -3,
  symmetricDifference: -4,
  complement: -5,
};

const fail = (message: string): never => {
  throw new KdManifoldError('INVALID_OPTION', `expression: ${message}`);
};

/**
 * @internal Checks an expression over so many operands and writes it in postfix order. A bare operation joins all of
 * them.
 */
export function postfix(
  expression: BooleanOperation | BooleanExpression,
  operands: number,
): Int32Array {
  const written: number[] = [];
  const write = (part: unknown): void => {
    if (typeof part === 'number') {
      if (!Number.isInteger(part) || part < 0 || part >= operands) {
        fail(`it names operand ${part}, but there are ${operands}, counted from 0`);
      }
      written.push(part);
      return;
    }
    if (!Array.isArray(part)) {
      fail(
        `expected the number of an operand or an array, got ${part === null ? 'null' : typeof part}`,
      );
    }
    const [operation, ...parts] = part as unknown[];
    const code = codeOf(operation);
    if (parts.length === 0) fail(`'${String(operation)}' needs one operand at least`);
    if (code === codes.complement && parts.length > 1) fail(`'complement' takes one operand`);
    parts.forEach((one, i) => {
      write(one);
      if (i > 0 || code === codes.complement) written.push(code);
    });
  };
  const all = Array.from({ length: operands }, (_, i) => i);
  write(typeof expression === 'string' ? [expression, ...all] : expression);
  return Int32Array.from(written);
}

function codeOf(operation: unknown): number {
  if (typeof operation === 'string' && Object.hasOwn(codes, operation)) {
    return codes[operation as BooleanOperation];
  }
  return fail(`expected one of ${Object.keys(codes).join(', ')}, got '${String(operation)}'`);
}
