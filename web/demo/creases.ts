// SPDX-License-Identifier: MIT
// The sharp edges of a mesh as line segments: edges between faces at an angle, and edges that have
// not exactly two faces. Vertices count as the same where their positions are. Plain typed arrays,
// since three's own EdgesGeometry takes seconds on large meshes.

/** End points of the segments, six numbers each; an edge is sharp from `degrees` on. */
export function creases(
  positions: ArrayLike<number>,
  indices: ArrayLike<number>,
  degrees = 30,
): Float32Array<ArrayBuffer> {
  const same = weld(positions);
  const normals = faceNormals(positions, indices);
  // Edge keys, smaller vertex first, with the face behind them: sorting brings the faces together.
  const vertices = positions.length / 3;
  const keys = new Float64Array(indices.length);
  for (let i = 0; i < indices.length; ++i) {
    const next = i % 3 === 2 ? i - 2 : i + 1;
    const a = at(same, at(indices, i));
    const b = at(same, at(indices, next));
    keys[i] = Math.min(a, b) * vertices + Math.max(a, b);
  }
  const order = Uint32Array.from(keys, (_, i) => i).sort((i, j) => at(keys, i) - at(keys, j));
  const limit = Math.cos((degrees * Math.PI) / 180);
  const lines: number[] = [];
  for (let i = 0; i < order.length;) {
    const key = at(keys, at(order, i));
    let end = i + 1;
    while (end < order.length && at(keys, at(order, end)) === key) ++end;
    const [f, g] = [Math.floor(at(order, i) / 3), Math.floor(at(order, end - 1) / 3)];
    if (end - i !== 2 || dot(normals, f, g) < limit) {
      const [a, b] = [Math.floor(key / vertices), key % vertices];
      for (const v of [a, b]) {
        lines.push(at(positions, 3 * v), at(positions, 3 * v + 1), at(positions, 3 * v + 2));
      }
    }
    i = end;
  }
  return Float32Array.from(lines);
}

const at = (array: ArrayLike<number>, i: number): number => array[i] as number;

function dot(normals: Float32Array, f: number, g: number): number {
  let sum = 0;
  for (let k = 0; k < 3; ++k) sum += at(normals, 3 * f + k) * at(normals, 3 * g + k);
  return sum;
}

function faceNormals(positions: ArrayLike<number>, indices: ArrayLike<number>): Float32Array {
  const normals = new Float32Array(indices.length);
  for (let t = 0; t < indices.length; t += 3) {
    const [a, b, c] = [3 * at(indices, t), 3 * at(indices, t + 1), 3 * at(indices, t + 2)];
    const edge = (to: number, k: number): number => at(positions, to + k) - at(positions, a + k);
    const x = edge(b, 1) * edge(c, 2) - edge(b, 2) * edge(c, 1);
    const y = edge(b, 2) * edge(c, 0) - edge(b, 0) * edge(c, 2);
    const z = edge(b, 0) * edge(c, 1) - edge(b, 1) * edge(c, 0);
    const length = Math.hypot(x, y, z) || 1;
    normals.set([x / length, y / length, z / length], t);
  }
  return normals;
}

// For each vertex the first one at its position: an open hash table over the bits of coordinates.
function weld(positions: ArrayLike<number>): Uint32Array {
  const floats = Float32Array.from(positions);
  const bits = new Uint32Array(floats.buffer);
  const count = floats.length / 3;
  const size = 2 ** Math.ceil(Math.log2(count * 2 + 1));
  const table = new Int32Array(size).fill(-1);
  const first = new Uint32Array(count);
  for (let v = 0; v < count; ++v) {
    let slot = 0;
    for (let k = 0; k < 3; ++k)
      slot = Math.imul(slot ^ at(bits, 3 * v + k), 0x9e3779b1) ^ (slot >>> 15);
    slot = (slot ^ (slot >>> 16)) & (size - 1);
    for (;;) {
      const other = at(table, slot);
      if (other < 0) {
        table[slot] = first[v] = v;
        break;
      }
      if (
        floats[3 * v] === floats[3 * other] &&
        floats[3 * v + 1] === floats[3 * other + 1] &&
        floats[3 * v + 2] === floats[3 * other + 2]
      ) {
        first[v] = other;
        break;
      }
      slot = (slot + 1) & (size - 1);
    }
  }
  return first;
}
