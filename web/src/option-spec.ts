// SPDX-License-Identifier: MIT
// What describes one option. The tables themselves are in options.ts.

/** @internal What is legal for one option, and what stands if it is left out. */
export type OptionSpec = {
  /** As it is typed on the command line. */
  flag: string;
} & (
  | { kind: 'choice'; words: readonly string[]; default?: string }
  | NumberSpec
  | { kind: 'boolean'; default: boolean }
  | { kind: 'numbers'; least: number }
  | { kind: 'box' }
  | { kind: 'text'; shortName?: string; repeats?: boolean }
);

/** @internal A number; without `most` and `below` any finite one that is large enough. */
export interface NumberSpec {
  kind: 'integer' | 'number';
  least: number;
  /** The largest that is legal. */
  most?: number;
  /** The smallest that is too large. */
  below?: number;
  /** Undefined: it depends on other options. */
  default?: number;
}

/** @internal One option for each property. */
export type OptionTable<T> = { readonly [K in keyof Required<T>]: OptionSpec };

/** @internal Whether a number is legal. */
export function isLegal(value: unknown, spec: NumberSpec): boolean {
  const { least, most = Infinity, below = Infinity } = spec;
  return (
    typeof value === 'number' &&
    (spec.kind === 'integer' ? Number.isInteger(value) : Number.isFinite(value)) &&
    value >= least &&
    value <= most &&
    value < below
  );
}

/** @internal Reads a decimal number that may have a sign; NaN if it is none. */
export const signedNumber = (text: string): number =>
  /^-?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(text) ? Number(text) : NaN;

/** @internal Whether these are the lowest and the highest corner of a box, which may be flat but no point. */
export function isBox(value: unknown): boolean {
  if (!Array.isArray(value) || value.length !== 6 || !value.every(Number.isFinite)) return false;
  const [low, high] = [value.slice(0, 3) as number[], value.slice(3) as number[]];
  return low.every((x, i) => x <= (high[i] as number)) && low.some((x, i) => x !== high[i]);
}

/** @internal The range as it completes "a number ...": "from 0 on", "from 0 to 180". */
export function rangeText({ least, most, below }: NumberSpec): string {
  if (below !== undefined) return `from ${least} to below ${below}`;
  return most === undefined ? `from ${least} on` : `from ${least} to ${most}`;
}
