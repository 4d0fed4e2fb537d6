// SPDX-License-Identifier: MIT
// 4x4 matrices in column order, in doubles: those of instances are stored in 32 bits, but the products
// with world matrices need not be.

export type Matrix = ArrayLike<number>;

/** The product that applies `b` first. */
export function multiply(a: Matrix, b: Matrix): Float64Array {
  const product = new Float64Array(16);
  for (let column = 0; column < 4; ++column) {
    for (let row = 0; row < 4; ++row) {
      let sum = 0;
      for (let k = 0; k < 4; ++k) sum += (a[4 * k + row] as number) * (b[4 * column + k] as number);
      product[4 * column + row] = sum;
    }
  }
  return product;
}

/**
 * What a matrix does to surfaces: 1: nothing, -1: mirrors them, 0: makes them flat (up to rounding),
 * NaN: it holds numbers that are not finite.
 */
export function orientationOf(matrix: Matrix): number {
  for (let i = 0; i < 16; ++i) if (!Number.isFinite(matrix[i])) return NaN;
  type Column = [number, number, number];
  const column = (i: number): Column =>
    Array.from({ length: 3 }, (_, row) => matrix[4 * i + row]) as Column;
  const [[a, b, c], [d, e, f], [g, h, i]] = [column(0), column(1), column(2)];
  const determinant = g * (b * f - c * e) + h * (c * d - a * f) + i * (a * e - b * d);
  const largest = Math.hypot(a, b, c) * Math.hypot(d, e, f) * Math.hypot(g, h, i);
  return Math.abs(determinant) <= 1e-12 * largest ? 0 : Math.sign(determinant);
}

/** Writes the transformed points to `to`, from its number `at` on. */
export function transformPoints(
  matrix: Matrix,
  points: Float64Array,
  to: Float64Array,
  at: number,
): void {
  const rows = [0, 1, 2, 3].map((row) => [0, 4, 8, 12].map((column) => matrix[column + row]));
  const [[ax, ay, az, a], [bx, by, bz, b], [cx, cy, cz, c], [wx, wy, wz, w]] = rows as [
    [number, number, number, number],
    [number, number, number, number],
    [number, number, number, number],
    [number, number, number, number],
  ];
  for (let i = 0; i < points.length; i += 3) {
    const x = points[i] as number;
    const y = points[i + 1] as number;
    const z = points[i + 2] as number;
    const scale = wx * x + wy * y + wz * z + w;
    to[at + i] = (ax * x + ay * y + az * z + a) / scale;
    to[at + i + 1] = (bx * x + by * y + bz * z + b) / scale;
    to[at + i + 2] = (cx * x + cy * y + cz * z + c) / scale;
  }
}
