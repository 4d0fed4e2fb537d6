// SPDX-License-Identifier: MIT
// The one call for most people.
import { checkGroups, checkMakeOptions, checkMesh } from './check-input.js';
import { buffersOf } from './convert.js';
import { jobKeys, jobOf, ownMesh, refuse, type JobOptions } from './job.js';
import type {
  BuildOptions,
  Conversion,
  ExtractOptions,
  GroupOptions,
  MeshInput,
  ReductionOptions,
} from './types.js';
import { submit } from './worker/pool.js';

/** Everything that `makeManifold` can be told. */
export interface MakeManifoldOptions
  extends BuildOptions, ExtractOptions, ReductionOptions, GroupOptions, JobOptions {
  /** Measure how far result and input are apart: `report.error`. Takes a fifth to two fifths longer. */
  check?: boolean;
}

const own = ['check', 'keepGroups', ...jobKeys];

/**
 * Makes a closed, oriented 2-manifold mesh of a mesh in whatever state: shells may overlap, nest and
 * intersect; with the default inside rule, `repair`, holes are closed and faces that are turned the
 * wrong way are turned back. (With `inside: 'sheet'` the result may have a boundary.) Works in a
 * worker (in Node: a worker thread), so that the calling thread stays free, one conversion after the
 * other unless `concurrency` allows more; where no worker can be started, on the calling thread, which
 * a warning and `report.thread` tell.
 *
 * The result has as few triangles as are found within the tolerance, in the numbers of `targetTriangles` if these
 * are given, and no two of them cross; `reduce: false` gives the grid's own.
 *
 * @param mesh - the triangles, in whatever state; their arrays are copied unless `transfer` is set
 * @param options - how to build and extract, where to work, how to be told and stopped
 * @returns the mesh, whose arrays are the caller's, and the account of how it was made
 * @throws {@link KdManifoldError} with `INVALID_MESH`, `INVALID_OPTION`, `NOT_CLOSED` (what encloses nothing),
 * `OUT_OF_MEMORY`, `ABORTED`, `LOAD_FAILED`; a signal's own reason where it was given one
 *
 * @example
 * ```js
 * import { makeManifold } from 'kdmanifold';
 *
 * const { mesh, report } = await makeManifold({ positions, indices }, { relativeTolerance: 0.002 });
 * console.log(mesh.indices.length / 3, report.output.twoManifold, report.thread);
 * ```
 */
export async function makeManifold(
  mesh: MeshInput,
  options: MakeManifoldOptions = {},
): Promise<Conversion> {
  const { reduction, ...checked } = checkMakeOptions(options, own);
  const groups = checkGroups(options);
  const { check = false } = options;
  if (typeof check !== 'boolean') refuse('check', 'true or false');
  const job = jobOf(options);
  const input = ownMesh(checkMesh(mesh), options);
  return submit({
    ...job,
    transfer: buffersOf(input),
    order: {
      type: 'convert',
      subject: { mesh: input },
      ...checked,
      reduction: { ...reduction, ...groups },
      check,
    },
  });
}
