// SPDX-License-Identifier: MIT
// The answer of `analyze`, made of flat arrays.
import type { RawDefects } from './kdmanifold-tools.js';
import { partKeys, type MeshDefects, type MeshPart } from './reports.js';

/** Makes arrays of the loops and objects of the parts. */
export function toDefects(raw: RawDefects): MeshDefects {
  const { loopVertices, loopEnds, partNumbers, ...others } = raw;
  const fields = partKeys.length;
  return {
    ...others,
    boundaryLoops: Array.from(loopEnds, (end, i) =>
      loopVertices.slice(i === 0 ? 0 : loopEnds[i - 1], end),
    ),
    parts: Array.from({ length: partNumbers.length / fields }, (_, i) =>
      toPart(partNumbers.subarray(fields * i, fields * (i + 1))),
    ),
  };
}

function toPart(numbers: Float64Array): MeshPart {
  const part = partKeys.map(([name, type], i) => {
    const number = numbers[i] as number;
    if (type === 'boolean') return [name, number !== 0];
    return [name, Number.isNaN(number) ? null : number];
  });
  return Object.fromEntries(part) as MeshPart;
}
