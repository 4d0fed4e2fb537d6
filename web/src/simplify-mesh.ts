// SPDX-License-Identifier: MIT
// Reduces a mesh in a worker.
import { checkMesh, checkReduceOptions } from './check-input.js';
import { buffersOf } from './convert.js';
import { jobKeys, jobOf, ownMesh, type JobOptions } from './job.js';
import type { GroupOptions, MeshInput, ReduceOptions, Simplification } from './types.js';
import { submit } from './worker/pool.js';

/** Everything that `simplifyMesh` can be told. */
export interface SimplifyMeshOptions extends ReduceOptions, GroupOptions, JobOptions {}

/**
 * Reduces a mesh to fewer triangles: within a distance of it, to a number of triangles, or both; several numbers make
 * several levels of detail. Parts and handles stay, and no two triangles cross. A mesh that is closed, 2-manifold and
 * crosses itself nowhere, once vertices of equal position are joined, is taken as it is; any other is first made so, as
 * by `makeManifold`. Works in a worker as `makeManifold` does.
 *
 * @param mesh - the triangles, in whatever state; their arrays are copied unless `transfer` is set
 * @param options - `error` in model units, `targetTriangles`, `keepGroups`, where to work, how to be told and stopped
 * @returns the mesh, the levels, and the account of how they were made
 * @throws {@link KdManifoldError} with `INVALID_MESH`, `INVALID_OPTION`, `NOT_CLOSED`, `EMPTY_RESULT`, `OUT_OF_MEMORY`,
 * `ABORTED`, `LOAD_FAILED`; a signal's own reason where it was given one
 *
 * @example
 * ```js
 * import { simplifyMesh } from 'kdmanifold';
 *
 * const { levels, report } = await simplifyMesh({ positions, indices }, { targetTriangles: [1000, 100] });
 * console.log(report.trianglesBefore, levels.map(({ indices }) => indices.length / 3));
 * ```
 */
export async function simplifyMesh(
  mesh: MeshInput,
  options: SimplifyMeshOptions,
): Promise<Simplification> {
  const reduce = checkReduceOptions(options, jobKeys);
  const job = jobOf(options);
  const input = ownMesh(checkMesh(mesh), options);
  return submit({
    ...job,
    transfer: buffersOf(input),
    order: { type: 'simplify', mesh: input, reduce },
  });
}
