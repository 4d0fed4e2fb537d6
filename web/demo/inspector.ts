// SPDX-License-Identifier: MIT
// The page's end of the worker that inspects inputs: one at a time, the newest.
import type { Reply, Source } from './inspect.worker';

export class Inspector {
  #worker: Worker | null = null;
  #busy = false;

  /** Inspects one input and calls `hear` with all that is found; the one before is dropped. */
  inspect(source: Source, hear: (reply: Reply) => void): void {
    this.stop();
    this.#busy = true;
    const worker = (this.#worker ??= open());
    worker.onmessage = ({ data }: MessageEvent<Reply>) => {
      this.#busy = data.type !== 'crossings' && data.type !== 'failed';
      hear(data);
    };
    worker.onerror = (event) => {
      this.stop();
      hear({ type: 'failed', message: event.message || 'the file could not be inspected' });
    };
    worker.postMessage(source);
  }

  /** Ends an inspection under way: the worker is deaf until then, so it goes with it. */
  stop(): void {
    if (!this.#busy) return;
    this.#worker?.terminate();
    this.#worker = null;
    this.#busy = false;
  }
}

function open(): Worker {
  // Bundlers recognise this very form and bundle the worker.
  return new Worker(new URL('./inspect.worker.ts', import.meta.url), { type: 'module' });
}
