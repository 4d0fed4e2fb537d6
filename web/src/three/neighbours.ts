// SPDX-License-Identifier: MIT
// Which triangles share an edge. Flat arrays and open hashing: meshes have millions of edges.

/** The power of two that keeps a hash table at most half full. */
const capacityFor = (count: number): number => 2 ** Math.ceil(Math.log2(2 * count + 2));

/**
 * The mates of edges. Edge `3 t + k` is that of triangle `t` from its corner `k` to the next; its mate is
 * the edge of another triangle with the same ends; -1: there is none. Of more than two edges with the
 * same ends the first two are mates.
 */
export function matesOf(corners: ArrayLike<number>): Int32Array {
  const count = corners.length;
  const mates = new Int32Array(count).fill(-1);
  const mask = capacityFor(count) - 1;
  const table = new Int32Array(mask + 1).fill(-1); // the first edge with these ends
  for (let edge = 0; edge < count; ++edge) {
    const a = corners[edge] as number;
    const b = corners[edge % 3 === 2 ? edge - 2 : edge + 1] as number;
    if (a === b) continue;
    const low = Math.min(a, b);
    const high = Math.max(a, b);
    let slot = (Math.imul(low, 0x9e3779b1) ^ Math.imul(high, 0x85ebca6b)) >>> 0;
    slot = (slot ^ (slot >>> 15)) & mask;
    for (; ; slot = (slot + 1) & mask) {
      const first = table[slot] as number;
      if (first < 0) {
        table[slot] = edge;
        break;
      }
      const c = corners[first] as number;
      const d = corners[first % 3 === 2 ? first - 2 : first + 1] as number;
      if (!((c === low && d === high) || (c === high && d === low))) continue;
      if ((mates[first] as number) < 0) {
        mates[first] = edge;
        mates[edge] = first;
      }
      break;
    }
  }
  return mates;
}

/**
 * Gives vertices one number if they are at the same place and have the same row of numbers, so that
 * triangles that continue each other without seam share vertices, whatever the index said.
 */
export function weld(positions: ArrayLike<number>, rows: Float64Array, width: number): Uint32Array {
  const count = positions.length / 3;
  const numbers = new Uint32Array(count);
  const mask = capacityFor(count) - 1;
  const table = new Int32Array(mask + 1).fill(-1);
  const bits = new Float64Array(1);
  const halves = new Uint32Array(bits.buffer);
  const same = (v: number, w: number): boolean => {
    for (let c = 0; c < 3; ++c) if (positions[3 * v + c] !== positions[3 * w + c]) return false;
    for (let c = 0; c < width; ++c) if (rows[width * v + c] !== rows[width * w + c]) return false;
    return true;
  };
  for (let v = 0; v < count; ++v) {
    let hash = 0;
    for (let c = 0; c < 3; ++c) {
      bits[0] = (positions[3 * v + c] as number) + 0; // no negative zero
      hash = Math.imul(hash ^ (halves[0] as number), 0x9e3779b1);
      hash = Math.imul(hash ^ (hash >>> 15) ^ (halves[1] as number), 0x85ebca6b);
    }
    let slot = (hash ^ (hash >>> 13)) & mask;
    let found = table[slot] as number;
    while (found >= 0 && !same(found, v)) {
      slot = (slot + 1) & mask;
      found = table[slot] as number;
    }
    if (found < 0) table[slot] = found = v;
    numbers[v] = found;
  }
  return numbers;
}
