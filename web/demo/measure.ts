// SPDX-License-Identifier: MIT
// Measures how far surfaces are apart, at points all over them.
import { BoxTree } from './box-tree';
import { tessellate, type Tessellation } from './tessellate';

/** A surface with a distance at each of its points. */
export interface Heat extends Tessellation {
  /** One number per position, in model units. */
  distances: Float32Array<ArrayBuffer>;
  largest: number;
}

/** A mesh as it is measured. */
export interface Surface {
  positions: Float32Array | Float64Array;
  indices: Uint32Array | Uint16Array | null;
}

// So many pieces tell of each surface; meshes of more triangles are looked at in each of their vertices.
const heatPieces = 60_000;
const apartPieces = 12_000;

/** How far the points of a surface are from others; what these are is prepared once. */
export class Reference {
  readonly #tree: BoxTree;
  readonly #points: () => ArrayLike<number>;

  constructor({ positions, indices }: Surface) {
    this.#tree = new BoxTree(positions, indices);
    let points: ArrayLike<number> | null = null;
    this.#points = () => (points ??= piecesOf({ positions, indices }, apartPieces).positions);
  }

  /** How far each point of a surface is from this one. */
  heat(surface: Surface): Heat {
    const pieces = piecesOf(surface, heatPieces);
    const { distances, largest } = distancesTo(this.#tree, pieces.positions);
    return { ...pieces, distances, largest };
  }

  /** The largest distance between points of a surface and this one, both ways. */
  apart(surface: Surface): number {
    const there = distancesTo(this.#tree, piecesOf(surface, apartPieces).positions);
    const tree = new BoxTree(surface.positions, surface.indices);
    return Math.max(there.largest, distancesTo(tree, this.#points()).largest);
  }
}

function piecesOf({ positions, indices }: Surface, most: number): Tessellation {
  const corners = indices ?? Uint32Array.from({ length: positions.length / 3 }, (_, i) => i);
  return tessellate(positions, corners, most);
}

// A point is no further away than the one before it, and as far as the two are apart.
function distancesTo(
  tree: BoxTree,
  points: ArrayLike<number>,
): { distances: Float32Array<ArrayBuffer>; largest: number } {
  const distances = new Float32Array(points.length / 3);
  let largest = 0;
  let last = Infinity;
  let [x, y, z] = [0, 0, 0];
  for (let i = 0; i < distances.length; ++i) {
    const [px, py, pz] = [3 * i, 3 * i + 1, 3 * i + 2].map((k) => points[k]) as Point;
    const most = (last + Math.hypot(px - x, py - y, pz - z)) * (1 + 1e-9);
    last = tree.distance(px, py, pz, most);
    [x, y, z] = [px, py, pz];
    distances[i] = last;
    largest = Math.max(largest, last);
  }
  return { distances, largest };
}

type Point = [number, number, number];
