// SPDX-License-Identifier: MIT
// The page's end of the worker that finds sharp edges.
import type { BufferGeometry } from 'three';
import type { CreaseReply, CreaseRequest } from './creases.worker';

export class CreaseFinder {
  // Bundlers recognise this very form and bundle the worker.
  readonly #worker = new Worker(new URL('./creases.worker.ts', import.meta.url), {
    type: 'module',
  });
  readonly #waiting = new Map<number, (lines: Float32Array) => void>();
  #asked = 0;

  constructor() {
    this.#worker.onmessage = ({ data }: MessageEvent<CreaseReply>) => {
      this.#waiting.get(data.id)?.(data.lines);
      this.#waiting.delete(data.id);
    };
  }

  /** The end points of the geometry's sharp edges, six numbers each. */
  find(geometry: BufferGeometry): Promise<Float32Array> {
    const request: CreaseRequest = {
      id: ++this.#asked,
      positions: geometry.getAttribute('position').array as Float32Array,
      indices: (geometry.getIndex()?.array as Uint32Array | undefined) ?? null,
    };
    return new Promise((resolve) => {
      this.#waiting.set(request.id, resolve);
      this.#worker.postMessage(request);
    });
  }
}
