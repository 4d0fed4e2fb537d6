// SPDX-License-Identifier: MIT
// Makes triangles of quads.
import type { PolygonMeshInput, WholeNumbers } from '../types.js';

/** A mesh of triangles only. */
export interface Triangles {
  positions: Float32Array | Float64Array;
  /** Null: every three positions are a triangle. */
  index: Uint16Array | Uint32Array | null;
  /** Three numbers per corner. */
  normals: Float32Array | null;
  /** One per triangle. */
  sourceFaces: Uint32Array | null;
  /** One per triangle; of Boolean operations only. */
  sourceOperands: Uint32Array | null;
}

// The corners of a quad, in the order in which its two triangles use them.
const quadCorners = [0, 1, 2, 0, 2, 3];

/** Makes two triangles of each quad; they come last. The arrays of a mesh without quads are shared. */
export function triangulate(mesh: PolygonMeshInput): Triangles {
  const { quads = null } = mesh;
  const positions = isPlain(mesh.positions) ? Float32Array.from(mesh.positions) : mesh.positions;
  const indices = drawable(mesh.indices ?? null);
  const normals = mesh.cornerNormals ?? null;
  const cornerNormals = normals && isPlain(normals) ? Float32Array.from(normals) : normals;
  const sourceFaces = wholeNumbers(mesh.sourceFaces);
  const sourceOperands = wholeNumbers(mesh.sourceOperands);
  if (quads === null) {
    return { positions, index: indices, normals: cornerNormals, sourceFaces, sourceOperands };
  }
  const first = indices?.length ?? 0;
  const index = new Uint32Array(first + (quads.length / 4) * 6);
  if (indices !== null) index.set(indices);
  for (let q = 0, to = first; q < quads.length; q += 4) {
    for (const corner of quadCorners) index[to++] = quads[q + corner] as number;
  }
  return {
    positions,
    index,
    normals: cornerNormals && withQuadNormals(cornerNormals, 3 * first, quads.length / 4),
    sourceFaces: sourceFaces && withQuadSources(sourceFaces, first / 3, quads.length / 4),
    sourceOperands: sourceOperands && withQuadSources(sourceOperands, first / 3, quads.length / 4),
  };
}

const isPlain = (array: ArrayLike<number>): array is readonly number[] => Array.isArray(array);

function wholeNumbers(given: WholeNumbers | null | undefined): Uint32Array | null {
  if (!given) return null;
  return given instanceof Uint32Array ? given : Uint32Array.from(given);
}

// WebGL draws with no others.
const drawable = (indices: WholeNumbers | null): Uint16Array | Uint32Array | null =>
  indices === null || indices instanceof Uint16Array || indices instanceof Uint32Array
    ? indices
    : Uint32Array.from(indices);

function withQuadNormals(normals: Float32Array, first: number, quads: number): Float32Array {
  const all = new Float32Array(first + 18 * quads);
  all.set(normals.subarray(0, first));
  for (let from = first, to = first; from < normals.length; from += 12) {
    for (const corner of quadCorners) {
      all.set(normals.subarray(from + 3 * corner, from + 3 * corner + 3), to);
      to += 3;
    }
  }
  return all;
}

function withQuadSources(sources: Uint32Array, first: number, quads: number): Uint32Array {
  const all = new Uint32Array(first + 2 * quads);
  all.set(sources.subarray(0, first));
  for (let q = 0; q < quads; ++q) {
    all.fill(sources[first + q] as number, first + 2 * q, first + 2 * q + 2);
  }
  return all;
}
