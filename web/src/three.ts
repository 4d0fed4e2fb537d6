// SPDX-License-Identifier: MIT
// `kdmanifold/three`: meshes from and to three.js geometries.
import { BufferAttribute, BufferGeometry } from 'three';
import type { InterleavedBufferAttribute } from 'three';
import { KdManifoldError } from './errors.js';
import type { PolygonMeshInput } from './types.js';

/**
 * The mesh of a geometry, as copies: positions and, if there is one, the index. Other attributes,
 * groups and the draw range are not looked at.
 */
export function fromBufferGeometry(geometry: BufferGeometry): {
  positions: Float32Array<ArrayBuffer> | Float64Array<ArrayBuffer>;
  indices: Uint32Array<ArrayBuffer> | null;
} {
  const attribute = geometry.getAttribute('position') as
    BufferAttribute | InterleavedBufferAttribute | undefined;
  if (attribute === undefined) {
    throw new KdManifoldError('INVALID_MESH', 'the geometry has no attribute "position"');
  }
  if (attribute.itemSize !== 3) {
    throw new KdManifoldError(
      'INVALID_MESH',
      `the attribute "position" has ${attribute.itemSize} numbers per vertex, not 3`,
    );
  }
  const Positions = attribute.array instanceof Float64Array ? Float64Array : Float32Array;
  const positions = new Positions(attribute.count * 3);
  // The getters see through interleaving and normalisation.
  for (let i = 0; i < attribute.count; ++i) {
    positions[3 * i] = attribute.getX(i);
    positions[3 * i + 1] = attribute.getY(i);
    positions[3 * i + 2] = attribute.getZ(i);
  }
  const index = geometry.getIndex();
  return { positions, indices: index === null ? null : Uint32Array.from(index.array) };
}

/**
 * A geometry with the mesh's arrays (not copies of them). It has no normals: use a material with
 * `flatShading`, or call `computeVertexNormals()`. Quads become two triangles each.
 */
export function toBufferGeometry(mesh: PolygonMeshInput): BufferGeometry {
  const geometry = new BufferGeometry();
  const { positions, indices = null, quads = null } = mesh;
  // WebGL knows no 64-bit numbers.
  const array = positions instanceof Float64Array ? Float32Array.from(positions) : positions;
  geometry.setAttribute('position', new BufferAttribute(array, 3));
  const index = quads === null ? indices : withQuads(indices, quads);
  if (index !== null) geometry.setIndex(new BufferAttribute(index, 1));
  return geometry;
}

function withQuads(indices: ArrayLike<number> | null, quads: Uint32Array): Uint32Array {
  const first = indices?.length ?? 0;
  const index = new Uint32Array(first + (quads.length / 4) * 6);
  if (indices !== null) index.set(indices);
  for (let q = 0, to = first; q < quads.length; q += 4) {
    for (const corner of [0, 1, 2, 0, 2, 3]) index[to++] = quads[q + corner] as number;
  }
  return index;
}
