// SPDX-License-Identifier: MIT
// Objects to be put into a scene.
import { Mesh } from 'three';
import type { Material } from 'three';
import type { PolygonMeshInput, Report } from '../types.js';
import { checkKeys } from './kinds.js';
import { checkSourced, type SourcedMesh } from './source.js';
import { toBufferGeometry, type ToBufferGeometryOptions } from './to-geometry.js';

/** What `toMesh` can be told. */
export interface ToMeshOptions extends Omit<ToBufferGeometryOptions, 'from'> {
  /** That of `makeManifold`: what one should know of the result goes along with the object. */
  report?: Pick<Report, 'lost' | 'error' | 'warnings'>;
}

/**
 * Makes an object of a mesh, with the attributes and the materials of what the mesh was made of. It
 * belongs where the objects were: at the root of the scene, since its coordinates are those of the world.
 *
 * Materials are those of the objects themselves, not copies, but for copies that show the colours of
 * instances. Without `cornerNormals`, which the option `normals` of `makeManifold` gives, its normals are
 * those of `computeVertexNormals()`: smooth everywhere but at seams.
 *
 * With `report`, the object's `userData.kdmanifold` has `lost` (without the list of faces, see `findLost`),
 * `error` and `warnings` of it: files of the scene keep them.
 *
 * @param mesh - A result that has `sourceFaces`.
 * @param from - What it was made of; of a Boolean operation an array, with the operands as they were given.
 * @param options - Those of `toBufferGeometry` but `from`, and `report`.
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
  from: SourcedMesh | readonly SourcedMesh[],
  options: ToMeshOptions = {},
): Mesh {
  checkKeys(options, ['transforms', 'attributes', 'seamTolerance', 'report']);
  const { report, ...others } = options;
  const materials = materialsOf(from);
  const geometry = toBufferGeometry(mesh, { ...others, from });
  if (!geometry.hasAttribute('normal')) geometry.computeVertexNormals();
  const object =
    materials.length === 0
      ? new Mesh(geometry)
      : new Mesh(geometry, geometry.groups.length > 0 ? materials : materials[0]);
  if (report) object.userData.kdmanifold = accountOf(report);
  return object;
}

function materialsOf(from: SourcedMesh | readonly SourcedMesh[]): Material[] {
  if (!Array.isArray(from)) return checkSourced(from as SourcedMesh).source.materials;
  const operands = from as readonly SourcedMesh[];
  return [...new Set(operands.flatMap((operand) => checkSourced(operand).source.materials))];
}

// Without the faces, which would fill files and mean nothing in another scene.
function accountOf({ lost, error, warnings }: NonNullable<ToMeshOptions['report']>): object {
  if (!lost) return { warnings };
  const { area, parts, largest, share, innerArea } = lost;
  return { lost: { area, parts, largest, share, innerArea }, error, warnings };
}
