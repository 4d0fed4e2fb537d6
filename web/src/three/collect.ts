// SPDX-License-Identifier: MIT
// Finds what has a surface in a tree of objects, and takes note of everything that is left out.
import type { Mesh, Object3D } from 'three';
import { is, isLevels, isMesh, nameOf, refuse } from './kinds.js';

/** Something that is not in the mesh, and why. */
export interface Skipped {
  object: Object3D;
  /** What it is, for people: its type, and its name or else its number. */
  name: string;
  reason: string;
}

/** What a tree of objects holds. */
export interface Collected {
  meshes: Mesh[];
  skipped: Skipped[];
}

// Fat lines are meshes to three.js.
const noSurfaces: [flag: string, reason: string][] = [
  ['isLine', 'lines have no surface'],
  ['isLine2', 'lines have no surface'],
  ['isLineSegments2', 'lines have no surface'],
  ['isPoints', 'points have no surface'],
  ['isSprite', 'a sprite has no surface of its own'],
];

// What cannot be read has a surface all the same. Leaving it out would lose a part of the model.
function refuseUnreadable(mesh: Mesh): void {
  const what = nameOf(mesh);
  const remedy = 'make single meshes of it, or make it invisible to leave it out';
  if (is(mesh, 'isBatchedMesh')) refuse(what, `a BatchedMesh cannot be read; ${remedy}`);
  if (!is(mesh.geometry, 'isBufferGeometry')) refuse(what, 'its geometry is no BufferGeometry');
  if (is(mesh.geometry, 'isInstancedBufferGeometry')) {
    refuse(
      what,
      `where the instances of an InstancedBufferGeometry are, only its shader knows; ${remedy}`,
    );
  }
}

const bearsGeometry = (object: Object3D): boolean =>
  'geometry' in object || object.children.some(bearsGeometry);

/** Lists the meshes at and below an object, without looking at their triangles. */
export function collect(root: Object3D, onlyVisible: boolean): Collected {
  const meshes: Mesh[] = [];
  const skipped: Skipped[] = [];
  const skip = (object: Object3D, reason: string): void => {
    skipped.push({ object, name: nameOf(object), reason });
  };
  const visit = (object: Object3D, shown: boolean): void => {
    if (!shown) {
      if (bearsGeometry(object)) skip(object, 'not visible');
      return;
    }
    const none = noSurfaces.find(([flag]) => is(object, flag));
    if (none !== undefined) skip(object, none[1]);
    else if (isMesh(object)) {
      refuseUnreadable(object);
      meshes.push(object);
    } else if ('geometry' in object) {
      skip(object, 'it is neither mesh nor lines nor points');
    }
    const levels = isLevels(object) ? object.levels.map((level) => level.object) : [];
    for (const child of object.children) {
      const level = levels.indexOf(child);
      if (level > 0) skip(child, `level ${level} of ${nameOf(object)}: the finest one is taken`);
      // Which level is visible says only how far away the camera was last.
      else visit(child, level === 0 || child.visible || !onlyVisible);
    }
  };
  visit(root, root.visible || !onlyVisible);
  return { meshes, skipped };
}
