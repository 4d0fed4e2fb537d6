// SPDX-License-Identifier: MIT
// The steps of a conversion: how much of the whole each is, and when it began.
import type { RawProgress, RawSteps } from './kdmanifold.js';
import type { ProgressOptions } from './types.js';

/** What is done one after the other. */
export type MakeStep = 'build' | 'simplify' | 'extract' | 'reduce';

/** Where each step begins and ends, as fractions of the whole. */
export type Shares = Partial<Record<MakeStep, readonly [from: number, to: number]>>;

// Measured on models of 10,000 to 200,000 triangles.
/** The shares where the result is reduced. A sound mesh that is simplified begins with the last. */
export const reducedShares: Shares = {
  build: [0, 0.18],
  simplify: [0.18, 0.2],
  extract: [0.2, 0.35],
  reduce: [0.35, 1],
};
/** The shares where it is not. */
export const plainShares: Shares = { build: [0, 0.7], simplify: [0.7, 0.77], extract: [0.77, 1] };

/** How a call of several steps is heard of. */
export interface StepOptions extends ProgressOptions {
  /** Called when a step begins; must not throw. */
  onStep?: (step: MakeStep) => void;
}

/** Makes of one callback for the whole what is told of every step. */
export function stepsOf(
  progress: RawProgress,
  shares: Shares,
  onStep?: (step: MakeStep) => void,
): RawSteps {
  return (step) => {
    onStep?.(step);
    const [from, to] = shares[step] ?? [0, 1];
    return progress && ((fraction, phase) => progress(from + (to - from) * fraction, phase));
  };
}
