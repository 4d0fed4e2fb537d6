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

/** @internal The range as it completes "a number ...": "from 0 on", "from 0 to 180". */
export function rangeText({ least, most, below }: NumberSpec): string {
  if (below !== undefined) return `from ${least} to below ${below}`;
  return most === undefined ? `from ${least} on` : `from ${least} to ${most}`;
}
