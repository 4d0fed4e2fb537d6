// SPDX-License-Identifier: MIT
// A mesh of all of one geometry, drawn or not.
import type { BufferGeometry } from 'three';
import { KdManifoldError } from '../errors.js';
import { readAttribute, type RawAttribute } from './attributes.js';
import { groupMaterials } from './drawn.js';
import { isGeometry, isObject, kindOf } from './kinds.js';
import type { MeshSource, SourcedMesh } from './source.js';

// `Float32Array<ArrayBuffer>` and the like: TypeScript before 5.7 knows no arguments of typed arrays.
type OwnFloat32Array = ReturnType<typeof Float32Array.of>;
type OwnFloat64Array = ReturnType<typeof Float64Array.of>;
type OwnUint32Array = ReturnType<typeof Uint32Array.of>;

/** What `fromBufferGeometry` gives: a mesh for `makeManifold` and the like. */
export interface GeometryMesh extends SourcedMesh {
  positions: OwnFloat32Array | OwnFloat64Array;
  indices: OwnUint32Array | null;
  source: MeshSource;
}

/**
 * Makes a mesh of a geometry, by copying its positions and, if there is one, its index: all of it, the
 * draw range and morph targets are not looked at. `fromObject3D` makes what three.js draws instead.
 *
 * @param geometry - The geometry. May be of another copy of three.js.
 * @returns A mesh to be given to `makeManifold`, and then, as `from`, to `toBufferGeometry`.
 * @throws KdManifoldError `INVALID_MESH` if there are no positions, or it is no geometry.
 * @example
 * ```ts
 * const box = fromBufferGeometry(new BoxGeometry(1, 2, 3));
 * const { mesh } = await makeManifold(box, { normals: true });
 * const geometry = toBufferGeometry(mesh, { from: box }); // with the box's UVs and groups
 * ```
 */
export function fromBufferGeometry(geometry: BufferGeometry): GeometryMesh {
  if (!isGeometry(geometry)) {
    const remedy = isObject(geometry) ? '; use fromObject3D' : '';
    fail(`geometry: expected a BufferGeometry of three.js, got ${kindOf(geometry)}${remedy}`);
  }
  const attribute = geometry.getAttribute('position') as RawAttribute | undefined;
  if (attribute === undefined) fail('the geometry has no attribute "position"');
  if (attribute.itemSize !== 3) {
    fail(`the attribute "position" has ${attribute.itemSize} numbers per vertex, not 3`);
  }
  const raw = attribute.data?.array ?? attribute.array;
  const { array, count } = readAttribute(attribute, 'the attribute "position"');
  const Positions = raw instanceof Float64Array ? Float64Array : Float32Array;
  const positions = new Positions(3 * count);
  for (let i = 0; i < positions.length; ++i) positions[i] = array[i] as number;
  const index = geometry.getIndex();
  const triangles = Math.floor((index === null ? count : index.count) / 3);
  const part = {
    object: null,
    geometry,
    instance: 0,
    influences: null,
    tint: null,
    coloured: true,
  };
  return {
    positions,
    indices: index === null ? null : Uint32Array.from(index.array),
    source: {
      parts: [{ ...part, firstTriangle: 0, firstVertex: 0 }],
      vertices: null,
      materialIndices: groupMaterials(geometry, 0, triangles),
      materials: [],
      grouped: geometry.groups.length > 0,
    },
  };
}

function fail(message: string): never {
  throw new KdManifoldError('INVALID_MESH', message);
}
