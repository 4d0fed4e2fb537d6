// SPDX-License-Identifier: MIT
// What a person who waits at a terminal sees, as src/cli/progress_line.h shows it.
import type { ProgressCallback } from '../types.js';

/** One line on standard error that is written over and over, and is gone at the end. */
export class ProgressLine {
  readonly #shown: boolean;
  #prefix = '';
  #text = ''; // what stands there

  /** If it is not `shown`, nothing is ever written. */
  constructor(shown: boolean) {
    this.#shown = shown;
  }

  /** What stands before all that follows, e.g. "2 of 5: ". */
  begin(prefix: string): void {
    this.#prefix = prefix;
  }

  /** Shows a step whose end nobody can foresee. */
  show(step: string): void {
    this.#write(this.#prefix + step);
  }

  /** Returns what shows how far a step is, with the phase of it. */
  of(step: string): ProgressCallback {
    this.show(step);
    return (fraction, phase) =>
      this.#write(`${this.#prefix}${step} ${Math.floor(100 * fraction)} %, ${phase}`);
  }

  /** Takes the line away. */
  clear(): void {
    if (this.#text !== '') process.stderr.write('\r\x1b[K');
    this.#text = '';
  }

  #write(text: string): void {
    if (!this.#shown || text === this.#text) return;
    process.stderr.write(`\r${text}\x1b[K`);
    this.#text = text;
  }
}
