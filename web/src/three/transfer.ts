// SPDX-License-Identifier: MIT
// Attributes of a source at the corners of a result's triangles: interpolated at the nearest point of
// the triangle that each stands for, or of one that continues it without seam.
import type { Table } from './columns.js';
import { hasSource } from './invented.js';
import { NearestPoint } from './nearest.js';
import { matesOf, weld } from './neighbours.js';
import type { SourcedMesh } from './source.js';

/** A mesh of triangles of which each stands for one of the source. */
export interface Target {
  positions: ArrayLike<number>;
  /** Vertices, three per triangle. */
  corners: ArrayLike<number>;
  /** Per triangle: that of the source. */
  sources: Uint32Array;
}

/** Carries a table of attributes over. */
export class Transfer {
  /** One row of numbers per corner. */
  readonly rows: Float64Array;
  #table: Table;
  #positions: ArrayLike<number>;
  #corners: ArrayLike<number>;
  #nearest: NearestPoint;
  /** Below this, the square of a distance is none. */
  #touching: number;
  /** Per number of a row: how different it may be where there is no seam. */
  #tolerances: Float64Array;
  // Where the rows are from: a triangle and the weights of its second and third corner.
  #triangles: Uint32Array;
  #weights: Float64Array;
  #scratch: Float64Array;

  constructor(from: SourcedMesh, table: Table, target: Target, seamTolerance: number) {
    const { positions, source } = from;
    const count = target.corners.length;
    this.#table = table;
    this.#positions = positions;
    this.#corners = from.indices ?? Uint32Array.from({ length: positions.length / 3 }, (_, i) => i);
    this.#touching = (1e-9 * largestExtent(positions, 3)) ** 2;
    const { materialIndices } = source;
    this.#nearest = nearestIn(positions, this.#corners, table, materialIndices, this.#touching);
    this.#tolerances = tolerancesOf(table, seamTolerance);
    this.rows = new Float64Array(table.width * count);
    this.#triangles = new Uint32Array(count);
    this.#weights = new Float64Array(2 * count);
    this.#scratch = new Float64Array(table.width);
    for (let corner = 0; corner < count; ++corner) this.#carry(target, corner);
  }

  /** Whether a corner may share the vertex that was made for another one at the same place. */
  same(made: number, corner: number): boolean {
    const { width } = this.#table;
    return (
      this.#alike(this.rows, width * made, corner) ||
      this.#continuous(made, corner) ||
      this.#continuous(corner, made)
    );
  }

  #carry({ positions, corners, sources }: Target, corner: number): void {
    const { columns, width } = this.#table;
    const source = sources[Math.floor(corner / 3)] as number;
    this.#triangles[corner] = source;
    if (!hasSource(source)) {
      for (const { name, offset, itemSize } of columns) {
        const at = width * corner + offset;
        this.rows.fill(name === 'color' ? 1 : 0, at, at + itemSize);
      }
      return;
    }
    const p = 3 * (corners[corner] as number);
    const nearest = this.#nearest;
    nearest.find(
      source,
      positions[p] as number,
      positions[p + 1] as number,
      positions[p + 2] as number,
    );
    this.#triangles[corner] = nearest.triangle;
    this.#weights[2 * corner] = nearest.second;
    this.#weights[2 * corner + 1] = nearest.third;
    this.#interpolate(this.rows, width * corner);
  }

  /** Writes the attributes at the point that was found last. */
  #interpolate(to: Float64Array, at: number): void {
    const { columns, rows, width } = this.#table;
    const { triangle, second, third } = this.#nearest;
    const a = width * (this.#corners[3 * triangle] as number);
    const b = width * (this.#corners[3 * triangle + 1] as number);
    const c = width * (this.#corners[3 * triangle + 2] as number);
    for (const { offset, itemSize, whole } of columns) {
      for (let i = offset; i < offset + itemSize; ++i) {
        const value = rows[a + i] as number;
        if (whole === null) {
          // In this form exact where all three are the same.
          to[at + i] =
            value +
            second * ((rows[b + i] as number) - value) +
            third * ((rows[c + i] as number) - value);
        } else if (second > 0.5 || (second >= third && second > 1 - second - third)) {
          to[at + i] = rows[b + i] as number;
        } else {
          to[at + i] =
            third > second && third > 1 - second - third ? (rows[c + i] as number) : value;
        }
      }
    }
  }

  #alike(row: Float64Array, at: number, corner: number): boolean {
    const { width } = this.#table;
    for (let i = 0; i < width; ++i) {
      const difference = (row[at + i] as number) - (this.rows[width * corner + i] as number);
      if (Math.abs(difference) > (this.#tolerances[i] as number)) return false;
    }
    return true;
  }

  /**
   * Two corners at one place may have come to different points, on the two sides of a fold. There is no
   * seam between them if the way from the one's triangle to the other's point leads to the same values.
   */
  #continuous(one: number, other: number): boolean {
    const from = this.#triangles[one] as number;
    const to = this.#triangles[other] as number;
    if (!hasSource(from) || !hasSource(to)) return false;
    const second = this.#weights[2 * other] as number;
    const third = this.#weights[2 * other + 1] as number;
    const coordinate = (c: number): number => {
      const at = (k: number): number =>
        this.#positions[3 * (this.#corners[3 * to + k] as number) + c] as number;
      return at(0) + second * (at(1) - at(0)) + third * (at(2) - at(0));
    };
    this.#nearest.find(from, coordinate(0), coordinate(1), coordinate(2));
    if (this.#nearest.distance > this.#touching) return false;
    this.#interpolate(this.#scratch, 0);
    return this.#alike(this.#scratch, 0, other);
  }
}

/** A walker that crosses neither seams nor the borders of materials. */
function nearestIn(
  positions: ArrayLike<number>,
  corners: ArrayLike<number>,
  table: Table,
  materials: Uint32Array,
  touching: number,
): NearestPoint {
  const welded = weld(positions, table.rows, table.width);
  const joined = new Uint32Array(corners.length);
  for (let i = 0; i < joined.length; ++i) joined[i] = welded[corners[i] as number] as number;
  const mates = matesOf(joined);
  for (let edge = 0; edge < mates.length; ++edge) {
    const mate = mates[edge] as number;
    const differ = materials[Math.floor(mate / 3)] !== materials[Math.floor(edge / 3)];
    if (mate >= 0 && differ) mates[edge] = mates[mate] = -1;
  }
  return new NearestPoint(positions, joined, mates, touching);
}

function tolerancesOf({ columns, rows, width }: Table, seamTolerance: number): Float64Array {
  const tolerances = new Float64Array(width);
  for (const { offset, itemSize, whole } of columns) {
    if (whole !== null) continue;
    const extent = largestExtent(rows, width, offset, itemSize);
    tolerances.fill(seamTolerance * extent, offset, offset + itemSize);
  }
  return tolerances;
}

/** The largest difference between two numbers of one column. */
function largestExtent(
  rows: ArrayLike<number>,
  width: number,
  offset = 0,
  itemSize = width,
): number {
  let largest = 0;
  for (let c = offset; c < offset + itemSize; ++c) {
    let [low, high] = [Infinity, -Infinity];
    for (let at = c; at < rows.length; at += width) {
      const value = rows[at] as number;
      if (value < low) low = value;
      if (value > high) high = value;
    }
    largest = Math.max(largest, high - low);
  }
  return largest;
}
