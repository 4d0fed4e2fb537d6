// SPDX-License-Identifier: MIT
// Objects to be put into a scene.
import { Mesh } from 'three';
import type { PolygonMeshInput } from '../types.js';
import { checkSourced, type SourcedMesh } from './source.js';
import { toBufferGeometry, type ToBufferGeometryOptions } from './to-geometry.js';

/**
 * Makes an object of a mesh, with the attributes and the materials of what the mesh was made of. It
 * belongs where the objects were: at the root of the scene, since its coordinates are those of the world.
 *
 * Materials are those of the objects themselves, not copies, but for copies that show the colours of
 * instances. Without `cornerNormals`, which the option `normals` of `makeManifold` gives, its normals are
 * those of `computeVertexNormals()`: smooth everywhere but at seams.
 *
 * @param mesh - A result that has `sourceFaces`.
 * @param from - What it was made of.
 * @param options - Those of `toBufferGeometry` but `from`.
 * @returns A new `Mesh` of three.js, with one material or an array of them.
 * @throws KdManifoldError As `toBufferGeometry` does.
 * @example
 * ```ts
 * const from = fromObject3D(model);
 * const { mesh } = await makeManifold(from, { normals: true });
 * model.visible = false;
 * scene.add(toMesh(mesh, from));
 * ```
 */
export function toMesh(
  mesh: PolygonMeshInput,
  from: SourcedMesh,
  options: Omit<ToBufferGeometryOptions, 'from'> = {},
): Mesh {
  const { materials } = checkSourced(from).source;
  const geometry = toBufferGeometry(mesh, { ...options, from });
  if (!geometry.hasAttribute('normal')) geometry.computeVertexNormals();
  if (materials.length === 0) return new Mesh(geometry);
  return new Mesh(geometry, geometry.groups.length > 0 ? materials : materials[0]);
}
