// SPDX-License-Identifier: MIT
// Where the vertices of a geometry are as an object shows it: morphed and bent by its bones.
import { Vector3 } from 'three';
import type { BufferGeometry, Object3D, SkinnedMesh } from 'three';
import { readMorphed } from './attributes.js';
import { isSkinned, refuse } from './kinds.js';

type Bend = (this: SkinnedMesh, vertex: number, point: Vector3) => Vector3;

/** The positions of some vertices in the object's own space. */
export function posedPositions(
  object: Object3D | null,
  geometry: BufferGeometry,
  influences: ArrayLike<number> | null,
  vertices: Uint32Array,
  what: string,
): Float64Array {
  const positions = new Float64Array(3 * vertices.length);
  const morphed = readMorphed(geometry, 'position', influences, what);
  if (morphed?.itemSize !== 3) {
    refuse(what, `its attribute "position" has ${morphed?.itemSize} numbers per vertex, not 3`);
  }
  const bend = isSkinned(object) ? bendBy(object, what) : null;
  const point = new Vector3();
  for (let i = 0; i < vertices.length; ++i) {
    const vertex = vertices[i] as number;
    for (let c = 0; c < 3; ++c) positions[3 * i + c] = morphed.array[3 * vertex + c] as number;
    if (bend !== null) bend(vertex, point.fromArray(positions, 3 * i)).toArray(positions, 3 * i);
    for (let c = 0; c < 3; ++c) {
      const value = positions[3 * i + c] as number;
      if (value - value !== 0) {
        const posed = Number.isFinite(morphed.array[3 * vertex + c]) ? ' as it is posed' : '';
        refuse(what, `coordinate ${'xyz'[c]} of vertex ${vertex}${posed} is ${value}`);
      }
    }
  }
  return positions;
}

/** The function of a skinned mesh that moves points with the bones: it was renamed in three r151. */
function bendBy(mesh: SkinnedMesh, what: string): (vertex: number, point: Vector3) => Vector3 {
  const { skinIndex, skinWeight } = mesh.geometry.attributes;
  if (skinIndex === undefined || skinWeight === undefined) {
    refuse(what, 'it is skinned, but has no attributes "skinIndex" and "skinWeight"');
  }
  if (!mesh.skeleton) refuse(what, 'it is skinned, but has no skeleton');
  // Bones may hang elsewhere than below the object.
  for (const bone of mesh.skeleton.bones) bone.updateWorldMatrix(true, false);
  const { applyBoneTransform, boneTransform } = mesh as { applyBoneTransform?: Bend } & {
    boneTransform?: Bend;
  };
  const bend = applyBoneTransform ?? boneTransform;
  if (typeof bend !== 'function') {
    refuse(what, 'it is skinned, but has neither applyBoneTransform nor boneTransform');
  }
  return (vertex, point) => bend.call(mesh, vertex, point);
}
