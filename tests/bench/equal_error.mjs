// SPDX-License-Identifier: MIT
// Finds the tolerance at which `adaptive` is at least as accurate as a given result, so that speed
// is compared at equal accuracy.

/**
 * `errorAt(tolerance)` gives the two-sided `{ max, rms }` of a run. Tolerances are tried on a ladder
 * of steps by the square root of two, each once however many errors are asked for.
 */
export class ToleranceLadder {
  #errors = new Map();
  #errorAt;

  constructor(errorAt) {
    this.#errorAt = errorAt;
  }

  /** The largest tolerance whose `max` or `rms` is at most `error`, or undefined (below 1e-5). */
  find(kind, error) {
    let step = nearestStep(kind === 'max' ? error : 3 * error);
    while (tolerance(step) > 1e-5 && !(this.#at(step)[kind] <= error)) ++step;
    if (tolerance(step) <= 1e-5) return undefined;
    // Two steps further, as an error need not grow with every step.
    const passes = [1, 2].filter((back) => this.#at(step - back)[kind] <= error);
    return tolerance(step - Math.max(0, ...passes));
  }

  #at(step) {
    if (!this.#errors.has(step)) this.#errors.set(step, this.#errorAt(tolerance(step)));
    return this.#errors.get(step);
  }
}

const tolerance = (step) => Number((0.064 * 2 ** (-step / 2)).toPrecision(3));
const nearestStep = (value) => Math.max(2, Math.round(-2 * Math.log2(value / 0.064)));
