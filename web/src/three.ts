// SPDX-License-Identifier: MIT
// `kdmanifold/three`: makes meshes of three.js geometries, and geometries of meshes.
import { BufferAttribute, BufferGeometry } from 'three';
import type { PolygonMeshInput } from './types.js';

export { fromBufferGeometry, type GeometryMesh } from './three/from-geometry.js';
export { fromObject3D, type FromObject3DOptions, type ObjectMesh } from './three/from-object.js';
export type { Skipped } from './three/collect.js';
export type { MeshSource, SourcedMesh, SourcePart } from './three/source.js';

/**
 * Makes a geometry of a mesh. Without `cornerNormals` it has the mesh's own arrays (not copies of them)
 * and no normals: use a material with `flatShading`, or call `computeVertexNormals()`. With them it has
 * the attribute "normal", and for that vertices of its own: one for every different normal at a vertex,
 * so that creases are sharp and all else is smooth. Quads become two triangles each.
 */
export function toBufferGeometry(mesh: PolygonMeshInput): BufferGeometry {
  const geometry = new BufferGeometry();
  const { positions, indices = null, quads = null, cornerNormals = null } = mesh;
  // WebGL knows no 64-bit numbers.
  const array = positions instanceof Float64Array ? Float32Array.from(positions) : positions;
  const index = quads === null ? indices : withQuads(indices, quads);
  if (cornerNormals === null) {
    geometry.setAttribute('position', new BufferAttribute(array, 3));
    if (index !== null) geometry.setIndex(new BufferAttribute(index, 1));
    return geometry;
  }
  const corners = quads === null ? cornerNormals : withQuadNormals(indices, quads, cornerNormals);
  const split = splitVertices(array, index, corners);
  geometry.setAttribute('position', new BufferAttribute(split.positions, 3));
  geometry.setAttribute('normal', new BufferAttribute(split.normals, 3));
  geometry.setIndex(new BufferAttribute(split.index, 1));
  return geometry;
}

/** Makes one vertex for every pair of a vertex and a normal that some corner has there. */
function splitVertices(
  positions: Float32Array,
  index: ArrayLike<number> | null,
  corners: Float32Array,
): { positions: Float32Array; normals: Float32Array; index: Uint32Array } {
  const count = corners.length / 3;
  const made = new Uint32Array(count); // per new vertex: the first corner that uses it
  const next = new Int32Array(count).fill(-1); // per new vertex: another one at the same place
  const newest = new Int32Array(positions.length / 3).fill(-1); // per vertex
  const numbers = new Uint32Array(count);
  const sameNormal = (a: number, b: number): boolean =>
    corners[3 * a] === corners[3 * b] &&
    corners[3 * a + 1] === corners[3 * b + 1] &&
    corners[3 * a + 2] === corners[3 * b + 2];
  let used = 0;
  for (let corner = 0; corner < count; ++corner) {
    const vertex = index === null ? corner : (index[corner] as number);
    let found = newest[vertex] as number;
    while (found >= 0 && !sameNormal(made[found] as number, corner)) found = next[found] as number;
    if (found < 0) {
      found = used++;
      made[found] = corner;
      next[found] = newest[vertex] as number;
      newest[vertex] = found;
    }
    numbers[corner] = found;
  }
  const split = {
    positions: new Float32Array(3 * used),
    normals: new Float32Array(3 * used),
    index: numbers,
  };
  for (let i = 0; i < used; ++i) {
    const corner = made[i] as number;
    const vertex = index === null ? corner : (index[corner] as number);
    split.positions.set(positions.subarray(3 * vertex, 3 * vertex + 3), 3 * i);
    split.normals.set(corners.subarray(3 * corner, 3 * corner + 3), 3 * i);
  }
  return split;
}

// The corners of a quad, in the order in which its two triangles use them.
const quadCorners = [0, 1, 2, 0, 2, 3];

function withQuadNormals(
  indices: ArrayLike<number> | null,
  quads: Uint32Array,
  normals: Float32Array,
): Float32Array {
  const first = 3 * (indices?.length ?? 0);
  const all = new Float32Array(first + (quads.length / 4) * 18);
  all.set(normals.subarray(0, first));
  for (let from = first, to = first; from < normals.length; from += 12) {
    for (const corner of quadCorners) {
      all.set(normals.subarray(from + 3 * corner, from + 3 * corner + 3), to);
      to += 3;
    }
  }
  return all;
}

function withQuads(indices: ArrayLike<number> | null, quads: Uint32Array): Uint32Array {
  const first = indices?.length ?? 0;
  const index = new Uint32Array(first + (quads.length / 4) * 6);
  if (indices !== null) index.set(indices);
  for (let q = 0, to = first; q < quads.length; q += 4) {
    for (const corner of quadCorners) index[to++] = quads[q + corner] as number;
  }
  return index;
}
