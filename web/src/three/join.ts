// SPDX-License-Identifier: MIT
// Puts surfaces at their places, into one pair of arrays.
import type { Material } from 'three';
import type { Showing } from './showings.js';
import type { MeshSource, SourcePart } from './source.js';
import { transformPoints } from './transform.js';

/** A mesh of several surfaces. */
export interface Joined {
  positions: Float64Array;
  indices: Uint32Array;
  source: MeshSource;
}

export function join(showings: Showing[], materials: Material[], grouped: boolean): Joined {
  const sum = (count: (showing: Showing) => number): number =>
    showings.reduce((total, showing) => total + count(showing), 0);
  const vertexCount = sum(({ surface }) => surface.vertices.length);
  const positions = new Float64Array(3 * vertexCount);
  const vertices = new Uint32Array(vertexCount);
  const indices = new Uint32Array(sum(({ surface }) => surface.corners.length));
  const materialIndices = new Uint32Array(indices.length / 3);
  const parts: SourcePart[] = [];
  let firstVertex = 0;
  let firstTriangle = 0;
  for (const { surface, matrix, mirrored, firstMaterial, part } of showings) {
    parts.push({ ...part, firstTriangle, firstVertex });
    transformPoints(matrix, surface.positions, positions, 3 * firstVertex);
    vertices.set(surface.vertices, firstVertex);
    const triangles = surface.materials.length;
    for (let t = 0; t < triangles; ++t) {
      materialIndices[firstTriangle + t] = firstMaterial + (surface.materials[t] as number);
      const to = 3 * (firstTriangle + t);
      // Turned, a mirrored triangle looks outwards again.
      const [second, third] = mirrored ? [2, 1] : [1, 2];
      indices[to] = firstVertex + (surface.corners[3 * t] as number);
      indices[to + 1] = firstVertex + (surface.corners[3 * t + second] as number);
      indices[to + 2] = firstVertex + (surface.corners[3 * t + third] as number);
    }
    firstVertex += surface.vertices.length;
    firstTriangle += triangles;
  }
  return { positions, indices, source: { parts, vertices, materialIndices, materials, grouped } };
}
