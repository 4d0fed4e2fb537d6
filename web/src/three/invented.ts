// SPDX-License-Identifier: MIT
// Triangles that close holes stand for no triangle of the input: they take after their neighbours.
import { matesOf } from './neighbours.js';

/** What stands for "none" in `sourceFaces`. */
const none = 0xffffffff;

/**
 * Gives triangles without a source that of the nearest triangle, counted in edges, that has one.
 * Where none of a connected part has, they stay without.
 */
export function withoutInvented(sources: Uint32Array, corners: ArrayLike<number>): Uint32Array {
  if (!sources.includes(none)) return sources;
  const filled = Uint32Array.from(sources);
  const mates = matesOf(corners);
  const line = new Uint32Array(filled.length);
  let end = 0;
  for (let t = 0; t < filled.length; ++t) if (filled[t] !== none) line[end++] = t;
  for (let begin = 0; begin < end; ++begin) {
    const triangle = line[begin] as number;
    for (let k = 0; k < 3; ++k) {
      const next = Math.floor((mates[3 * triangle + k] as number) / 3);
      if (next < 0 || filled[next] !== none) continue;
      filled[next] = filled[triangle] as number;
      line[end++] = next;
    }
  }
  return filled;
}

/** Whether a triangle has a source. */
export const hasSource = (source: number): boolean => source !== none;
