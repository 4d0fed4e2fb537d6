// SPDX-License-Identifier: MIT
// Work that is asked for more often than it can be done: one at a time, and in the end the newest.

export class Latest {
  #isRunning = false;
  #isWanted = false;

  /** `work` finds out by itself what there is to be done. */
  constructor(readonly work: () => Promise<void>) {}

  /** Works as soon as what is under way has ended. */
  go(): void {
    this.#isWanted = true;
    if (!this.#isRunning) void this.#run();
  }

  /** What was asked for is wanted no more. */
  stop(): void {
    this.#isWanted = false;
  }

  async #run(): Promise<void> {
    this.#isRunning = true;
    while (this.#isWanted) {
      this.#isWanted = false;
      await this.work();
    }
    this.#isRunning = false;
  }
}
