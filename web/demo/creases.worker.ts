// SPDX-License-Identifier: MIT
// Finds sharp edges off the page's own thread: a second's work on a large model.
import { creases } from './creases';

/** To the worker. */
export interface CreaseRequest {
  id: number;
  positions: Float32Array | Float64Array;
  /** Without: every three positions are a triangle. */
  indices: Uint32Array | Uint16Array | null;
}

/** From the worker: end points, six numbers a line. */
export interface CreaseReply {
  id: number;
  lines: Float32Array<ArrayBuffer>;
}

// TypeScript has the types of a page or of a worker, never both.
const scope = globalThis as unknown as {
  onmessage: (event: MessageEvent<CreaseRequest>) => void;
  postMessage(reply: CreaseReply, transfer: ArrayBuffer[]): void;
};

scope.onmessage = ({ data: { id, positions, indices } }) => {
  const corners = indices ?? Uint32Array.from({ length: positions.length / 3 }, (_, i) => i);
  const lines = creases(positions, corners);
  scope.postMessage({ id, lines }, [lines.buffer]);
};
