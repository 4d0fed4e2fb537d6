// SPDX-License-Identifier: MIT
// The answer of `analyze`, made of flat arrays.
import type { RawDefects } from './kdmanifold.js';
import type { MeshDefects, MeshPart } from './types.js';

const none = 0xffffffff;

/** Loops become arrays of their own, parts become objects. */
export function toDefects(raw: RawDefects): MeshDefects {
  const { loopVertices, loopEnds, partCounts, partSizes, ...lists } = raw;
  return {
    ...lists,
    boundaryLoops: Array.from(loopEnds, (end, i) =>
      loopVertices.slice(i === 0 ? 0 : loopEnds[i - 1], end),
    ),
    parts: Array.from({ length: partSizes.length / 2 }, (_, i) =>
      toPart(partCounts.subarray(8 * i, 8 * i + 8), partSizes.subarray(2 * i, 2 * i + 2)),
    ),
  };
}

function toPart(counts: Uint32Array, sizes: Float64Array): MeshPart {
  const [firstFace, faces, boundaryLoops, genus, inside, closed, cavity, insideOut] =
    counts as unknown as [number, number, number, number, number, number, number, number];
  const [area, volume] = sizes as unknown as [number, number];
  return {
    firstFace,
    faces,
    boundaryLoops,
    closed: closed !== 0,
    genus: genus === none ? null : genus,
    area,
    volume,
    inside: inside === none ? null : inside,
    cavity: cavity !== 0,
    insideOut: insideOut !== 0,
  };
}
