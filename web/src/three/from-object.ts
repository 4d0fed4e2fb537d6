// SPDX-License-Identifier: MIT
// One mesh of all that three.js draws of an object, in the space of the world.
import type { BufferGeometry, Object3D } from 'three';
import { KdManifoldError } from '../errors.js';
import { collect, type Skipped } from './collect.js';
import { drawnTriangles, groupMaterials } from './drawn.js';
import { join } from './join.js';
import { checkKeys, isGeometry, isObject, kindOf, nameOf, refuse } from './kinds.js';
import { MaterialList } from './materials.js';
import { showingsOf, type Showing } from './showings.js';
import type { MeshSource, SourcedMesh } from './source.js';
import { surfaceOf } from './surface.js';

/** What `fromObject3D` can be told. */
export interface FromObject3DOptions {
  /** Leave out what is not visible, with all below it, and materials that are not (default: true). */
  onlyVisible?: boolean;
}

/** What `fromObject3D` gives: a mesh for `makeManifold` and the like. */
export interface ObjectMesh extends SourcedMesh {
  /** In the space of the world, as 64-bit numbers. */
  positions: Float64Array;
  indices: Uint32Array;
  /** Which object, instance, vertex and material is behind each triangle. */
  source: MeshSource;
  /** What is not in the mesh, and why: lines, points and sprites, what is not visible or not drawn. */
  skipped: Skipped[];
}

/**
 * Makes one mesh of an object and all below it, or of a geometry: of the triangles that three.js draws,
 * as it draws them. World matrices are brought up to date and applied in 64 bits; where they mirror,
 * triangles are turned, so that the outside stays outside. Draw ranges and groups count, every instance
 * of an `InstancedMesh` is there, and morph targets and bones are applied as they are now. Of an `LOD`
 * the finest level is taken. Of a geometry alone, its draw range counts, and its groups give the numbers
 * of materials.
 *
 * Nothing is lost silently: `skipped` lists lines, points, sprites, what is not visible, instances
 * that are scaled to nothing, and triangles that no material draws. A surface that cannot be read (a
 * `BatchedMesh`, an `InstancedBufferGeometry`) is an error. What shaders do (displacement maps,
 * clipping planes) is not known here.
 *
 * @param object - The object or geometry. May be of another copy of three.js.
 * @param options - What is to be left out.
 * @returns A mesh to be given to `makeManifold`, and then, as `from`, to `toBufferGeometry` or `toMesh`.
 * @throws KdManifoldError `INVALID_MESH`, with the object's name, if there is a number that is not
 * finite, an index beyond the last vertex, an unfinished triangle, or a surface that cannot be read;
 * if `object` is no object of three.js; and if nothing remains. `INVALID_OPTION` for options unknown.
 * @example
 * ```ts
 * const from = fromObject3D(scene);
 * const { mesh } = await makeManifold(from, { normals: true });
 * scene.add(toMesh(mesh, from));
 * ```
 */
export function fromObject3D(
  object: Object3D | BufferGeometry,
  options: FromObject3DOptions = {},
): ObjectMesh {
  checkKeys(options, ['onlyVisible']);
  const { onlyVisible = true } = options;
  if (typeof onlyVisible !== 'boolean') {
    throw new KdManifoldError('INVALID_OPTION', 'onlyVisible: expected true or false');
  }
  if (isGeometry(object)) return fromGeometry(object);
  if (!isObject(object)) {
    refuse('object', `expected an Object3D or a BufferGeometry of three.js, got ${kindOf(object)}`);
  }
  object.updateWorldMatrix(true, false);
  object.updateMatrixWorld(true);
  const { meshes, skipped } = collect(object, onlyVisible);
  const list = new MaterialList();
  const showings = meshes.flatMap((mesh) => showingsOf(mesh, onlyVisible, list, skipped));
  if (showings.length === 0) refuse(nameOf(object), nothingIn(skipped));
  const several = meshes.some((mesh) => Array.isArray(mesh.material));
  return {
    ...join(showings, list.materials, several || list.materials.length > 1),
    skipped,
  };
}

function nothingIn(skipped: Skipped[]): string {
  if (skipped.length === 0) return 'there is no mesh in it';
  const { name, reason } = skipped[0] as Skipped;
  const more = skipped.length > 1 ? `, and ${skipped.length - 1} more` : '';
  return `nothing in it has a surface that is drawn (${name}: ${reason}${more})`;
}

const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

function fromGeometry(geometry: BufferGeometry): ObjectMesh {
  const what = nameOf(geometry);
  if (geometry.getAttribute('position') === undefined) {
    refuse(what, 'the geometry has no attribute "position"');
  }
  const drawn = drawnTriangles(geometry, null, what);
  const triangles = drawn.materials.length;
  if (triangles === 0) refuse(what, 'no triangle of the geometry is drawn');
  drawn.materials = groupMaterials(geometry, Math.max(geometry.drawRange.start, 0), triangles);
  const showing: Showing = {
    surface: surfaceOf(null, geometry, null, drawn, what),
    matrix: identity,
    mirrored: false,
    firstMaterial: 0,
    part: { object: null, geometry, instance: 0, influences: null, tint: null, coloured: true },
  };
  return { ...join([showing], [], geometry.groups.length > 0), skipped: [] };
}
