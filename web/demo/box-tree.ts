// SPDX-License-Identifier: MIT
// Triangles in a tree of boxes, to find how far points are from them. The tree is balanced, so a node's
// place says which triangles it holds: children of node i are 2 i + 1 and 2 i + 2, each with half.
import { squaredDistance } from './triangle-distance';

const leafSize = 4;

export class BoxTree {
  /** Nine numbers a triangle, in the order of the leaves. */
  readonly #corners: Float64Array;
  /** Six numbers a node: least and greatest coordinates. */
  readonly #boxes: Float64Array;
  readonly #count: number;

  /** Without `indices` every three positions are a triangle; at least one is needed. */
  constructor(positions: ArrayLike<number>, indices: ArrayLike<number> | null) {
    const corners = indices?.length ?? positions.length / 3;
    this.#count = corners / 3;
    const loose = new Float64Array(3 * corners);
    for (let i = 0; i < loose.length; ++i) {
      const corner = Math.floor(i / 3);
      loose[i] = at(positions, 3 * (indices ? at(indices, corner) : corner) + (i % 3));
    }
    const middles = new Float64Array(corners);
    for (let i = 0; i < middles.length; ++i) {
      const first = 9 * Math.floor(i / 3) + (i % 3);
      middles[i] = at(loose, first) + at(loose, first + 3) + at(loose, first + 6);
    }
    const order = Uint32Array.from({ length: this.#count }, (_, t) => t);
    arrange(order, middles, 0, this.#count);
    this.#corners = new Float64Array(loose.length);
    order.forEach((t, i) => this.#corners.set(loose.subarray(9 * t, 9 * t + 9), 9 * i));
    this.#boxes = new Float64Array(6 * 2 ** (2 + Math.ceil(Math.log2(this.#count))));
    this.#bound(0, 0, this.#count);
  }

  /** The distance of a point from the nearest triangle; `most` if that is no nearer. */
  distance(x: number, y: number, z: number, most = Infinity): number {
    return Math.sqrt(this.#search(0, 0, this.#count, [x, y, z], most * most));
  }

  #search(node: number, from: number, to: number, point: Point, best: number): number {
    if (to - from <= leafSize) {
      for (let t = from; t < to; ++t) {
        best = Math.min(best, squaredDistance(this.#corners, 9 * t, ...point));
      }
      return best;
    }
    const middle = (from + to) >> 1;
    const [left, right] = [2 * node + 1, 2 * node + 2];
    const nearLeft = this.#reach(left, point);
    const nearRight = this.#reach(right, point);
    const goLeft = (): void => {
      if (nearLeft < best) best = this.#search(left, from, middle, point, best);
    };
    if (nearLeft <= nearRight) goLeft();
    if (nearRight < best) best = this.#search(right, middle, to, point, best);
    if (nearLeft > nearRight) goLeft();
    return best;
  }

  // The square of the distance from a box.
  #reach(node: number, point: Point): number {
    let sum = 0;
    for (let axis = 0; axis < 3; ++axis) {
      const p = point[axis] as number;
      const below = at(this.#boxes, 6 * node + axis) - p;
      const above = p - at(this.#boxes, 6 * node + 3 + axis);
      const off = Math.max(below, above, 0);
      sum += off * off;
    }
    return sum;
  }

  #bound(node: number, from: number, to: number): void {
    const box = this.#boxes.subarray(6 * node, 6 * node + 6);
    box.fill(Infinity, 0, 3).fill(-Infinity, 3);
    for (let i = 9 * from; i < 9 * to; ++i) {
      const value = at(this.#corners, i);
      if (value < at(box, i % 3)) box[i % 3] = value;
      if (value > at(box, 3 + (i % 3))) box[3 + (i % 3)] = value;
    }
    if (to - from <= leafSize) return;
    const middle = (from + to) >> 1;
    this.#bound(2 * node + 1, from, middle);
    this.#bound(2 * node + 2, middle, to);
  }
}

type Point = [number, number, number];

const at = (array: ArrayLike<number>, i: number): number => array[i] as number;

// Puts the half of the triangles that lies lower along the longest axis first, and so on in each half.
function arrange(order: Uint32Array, middles: Float64Array, from: number, to: number): void {
  if (to - from <= leafSize) return;
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = from; i < to; ++i) {
    for (let k = 0; k < 3; ++k) {
      const value = at(middles, 3 * at(order, i) + k);
      low[k] = Math.min(at(low, k), value);
      high[k] = Math.max(at(high, k), value);
    }
  }
  const extents = high.map((value, k) => value - at(low, k));
  const axis = extents.indexOf(Math.max(...extents));
  const middle = (from + to) >> 1;
  divide(order, (t) => at(middles, 3 * t + axis), from, to, middle);
  arrange(order, middles, from, middle);
  arrange(order, middles, middle, to);
}

// Puts what is less than the one that belongs to `middle` before it, and what is greater behind it (Hoare's
// selection).
function divide(
  order: Uint32Array,
  key: (triangle: number) => number,
  from: number,
  to: number,
  middle: number,
): void {
  let [first, last] = [from, to - 1];
  while (first < last) {
    const pivot = key(at(order, (first + last) >> 1));
    let [i, j] = [first, last];
    while (i <= j) {
      while (key(at(order, i)) < pivot) ++i;
      while (key(at(order, j)) > pivot) --j;
      if (i > j) break;
      [order[i], order[j]] = [at(order, j), at(order, i)];
      ++i;
      --j;
    }
    if (middle <= j) last = j;
    else if (middle >= i) first = i;
    else return;
  }
}
