// SPDX-License-Identifier: MIT
// Geometries that do not share the arrays of a mesh: their vertices are made of corners.
import { BufferAttribute, BufferGeometry } from 'three';
import type { Triangles } from './polygons.js';

/** The vertex of each corner. */
export const cornersOf = ({ positions, index }: Triangles): Uint16Array | Uint32Array =>
  index ?? Uint32Array.from({ length: positions.length / 3 }, (_, i) => i);

/** Picks the numbers of some items, `size` each. */
function picked(array: ArrayLike<number>, items: ArrayLike<number>, size: number): Float32Array {
  const taken = new Float32Array(items.length * size);
  for (let i = 0; i < items.length; ++i) {
    const from = size * (items[i] as number);
    for (let c = 0; c < size; ++c) taken[size * i + c] = array[from + c] as number;
  }
  return taken;
}

/** Whether two corners have the same normal. */
export const sameNormal = (normals: Float32Array, a: number, b: number): boolean =>
  normals[3 * a] === normals[3 * b] &&
  normals[3 * a + 1] === normals[3 * b + 1] &&
  normals[3 * a + 2] === normals[3 * b + 2];

/** Makes a geometry with the attributes "position" and, if there are any, "normal". */
export function geometryOf(
  { positions, normals }: Triangles,
  corners: ArrayLike<number>,
  made: Uint32Array,
  index: Uint32Array,
): BufferGeometry {
  const geometry = new BufferGeometry();
  const vertices = new Uint32Array(made.length);
  for (let i = 0; i < made.length; ++i) vertices[i] = corners[made[i] as number] as number;
  geometry.setAttribute('position', new BufferAttribute(picked(positions, vertices, 3), 3));
  if (normals !== null) {
    geometry.setAttribute('normal', new BufferAttribute(picked(normals, made, 3), 3));
  }
  return geometry.setIndex(new BufferAttribute(index, 1));
}
