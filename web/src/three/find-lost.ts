// SPDX-License-Identifier: MIT
// Which triangles of which objects a result lacks.
import type { BufferGeometry, Object3D } from 'three';
import type { Report } from '../types.js';
import { checkSourced, type SourcedMesh } from './source.js';

/** What a result lacks of one object. */
export interface LostTriangles {
  /** The object; null if a geometry alone was given. */
  object: Object3D | null;
  geometry: BufferGeometry;
  /** Of an `InstancedMesh`; else 0. */
  instance: number;
  /** Numbers of triangles of the mesh `from`: three of its `indices` each. */
  triangles: Uint32Array;
}

/**
 * Says of which objects something is missing from a result.
 *
 * @param from - What the mesh was made of.
 * @param report - That of `makeManifold`, or what `Grid.compare` returned.
 * @returns One entry for each object, or instance of one, that lacks triangles in whole or part, in the order
 * in which `fromObject3D` found them. Empty if nothing is missing, and for reports of Boolean operations, which do not
 * say it.
 * @throws KdManifoldError `INVALID_MESH` if `from` is not what it was made as.
 * @example
 * ```ts
 * const from = fromObject3D(model);
 * const { report } = await makeManifold(from);
 * for (const { object, triangles } of findLost(from, report)) {
 *   console.warn(`${object?.name}: ${triangles.length} triangles are missing`);
 * }
 * ```
 */
export function findLost(from: SourcedMesh, { lost }: Pick<Report, 'lost'>): LostTriangles[] {
  const { parts, materialIndices } = checkSourced(from).source;
  return parts
    .map(({ object, geometry, instance, firstTriangle }, i) => {
      const end = parts[i + 1]?.firstTriangle ?? materialIndices.length;
      const inPart = (face: number): boolean => face >= firstTriangle && face < end;
      const triangles = lost?.faces.filter(inPart) ?? new Uint32Array();
      return { object, geometry, instance, triangles };
    })
    .filter(({ triangles }) => triangles.length > 0);
}
