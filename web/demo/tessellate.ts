// SPDX-License-Identifier: MIT
// Cuts the triangles of a mesh into smaller ones, so that what is measured at their corners tells of
// all of the surface.

/** Triangles that lie on those of a mesh. The mesh's own vertices come first, in their order. */
export interface Tessellation {
  positions: Float32Array<ArrayBuffer>;
  indices: Uint32Array<ArrayBuffer>;
}

/**
 * Cuts each triangle as often as it is long, so that in all there are at most `most`, or as many as there are
 * already. Neighbours may be cut differently.
 */
export function tessellate(
  positions: ArrayLike<number>,
  indices: ArrayLike<number>,
  most: number,
): Tessellation {
  const lengths = longestSides(positions, indices);
  const step = stepFor(lengths, most);
  const points: number[] = Array.from(positions);
  const corners: number[] = [];
  lengths.forEach((length, t) => {
    const [a, b, c] = [0, 1, 2].map((k) => at(indices, 3 * t + k)) as [number, number, number];
    const n = cuts(length, step);
    // Rows from a on: row i has i + 1 points, the last one lies on the side from b to c.
    const rows: number[][] = [];
    for (let i = 0; i <= n; ++i) {
      rows.push([]);
      for (let j = 0; j <= i; ++j) {
        const own = i === 0 ? a : i < n ? null : j === 0 ? b : j === n ? c : null;
        rows[i]?.push(own ?? points.length / 3);
        if (own !== null) continue;
        for (let k = 0; k < 3; ++k) {
          const [pa, pb, pc] = [a, b, c].map((v) => at(positions, 3 * v + k)) as [
            number,
            number,
            number,
          ];
          points.push(pa + ((i - j) / n) * (pb - pa) + (j / n) * (pc - pa));
        }
      }
    }
    for (let i = 0; i < n; ++i) {
      const [row, next] = [rows[i] as number[], rows[i + 1] as number[]];
      for (let j = 0; j <= i; ++j) {
        corners.push(at(row, j), at(next, j), at(next, j + 1));
        if (j < i) corners.push(at(row, j), at(next, j + 1), at(row, j + 1));
      }
    }
  });
  return { positions: Float32Array.from(points), indices: Uint32Array.from(corners) };
}

const at = (array: ArrayLike<number>, i: number): number => array[i] as number;

const cuts = (length: number, step: number): number => Math.max(1, Math.ceil(length / step));

// The least length of a piece with which there are not too many.
function stepFor(lengths: Float64Array, most: number): number {
  const longest = lengths.reduce((a, b) => Math.max(a, b), 0);
  if (lengths.length >= most) return Math.max(longest, Number.MIN_VALUE);
  let [few, many] = [Math.max(longest, Number.MIN_VALUE), 0];
  for (let round = 0; round < 20; ++round) {
    const step = (few + many) / 2;
    let sum = 0;
    for (const length of lengths) sum += cuts(length, step) ** 2;
    if (sum > most) many = step;
    else few = step;
  }
  return few;
}

function longestSides(positions: ArrayLike<number>, indices: ArrayLike<number>): Float64Array {
  const lengths = new Float64Array(indices.length / 3);
  for (let i = 0; i < indices.length; ++i) {
    const a = 3 * at(indices, i);
    const b = 3 * at(indices, i % 3 === 2 ? i - 2 : i + 1);
    const length = Math.hypot(
      at(positions, a) - at(positions, b),
      at(positions, a + 1) - at(positions, b + 1),
      at(positions, a + 2) - at(positions, b + 2),
    );
    const t = Math.floor(i / 3);
    lengths[t] = Math.max(at(lengths, t), length);
  }
  return lengths;
}
