// SPDX-License-Identifier: MIT
// The one call for most people.
import {
  checkBuildOptions,
  checkExtractOptions,
  checkMesh,
  type CheckedMesh,
} from './check-input.js';
import { buffersOf } from './convert.js';
import { aborted, KdManifoldError } from './errors.js';
import { checkSource, sourceKeys, type LoadOptions, type WorkerOptions } from './load-options.js';
import { buildOptions, extractOptions } from './options.js';
import type { Signal } from './outside-types.js';
import type {
  BuildOptions,
  Conversion,
  ExtractOptions,
  MeshInput,
  ProgressOptions,
} from './types.js';
import { submit } from './worker/pool.js';

/** Everything that `makeManifold` can be told. */
export interface MakeManifoldOptions
  extends BuildOptions, ExtractOptions, ProgressOptions, LoadOptions, WorkerOptions {
  /**
   * Stops the conversion, which then rejects with the reason that the signal was given; where it was given none, with
   * `ABORTED`.
   */
  signal?: Signal;
  /** Hand the mesh's arrays over instead of copying them; they are empty afterwards. */
  transfer?: boolean;
  /** Measure how far result and input are apart: `report.error`. Takes a fifth to two fifths longer. */
  check?: boolean;
}

const own = ['onProgress', 'signal', 'transfer', 'check', ...sourceKeys];

/**
 * Makes a closed, oriented 2-manifold mesh of a mesh in whatever state: shells may overlap, nest and
 * intersect; with the default inside rule, `repair`, holes are closed and faces that are turned the
 * wrong way are turned back. (With `inside: 'sheet'` the result may have a boundary.) Works in a
 * worker (in Node: a worker thread), so that the calling thread stays free, one conversion after the
 * other unless `concurrency` allows more; where no worker can be started, on the calling thread, which
 * a warning and `report.thread` tell.
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
  const build = checkBuildOptions(options, [...own, ...Object.keys(extractOptions)]);
  const extract = checkExtractOptions(options, [...own, ...Object.keys(buildOptions)]);
  const { onProgress, signal, transfer = false, check = false } = options;
  const source = checkSource(options);
  if (typeof transfer !== 'boolean') refuse('transfer', 'true or false');
  if (typeof check !== 'boolean') refuse('check', 'true or false');
  if (onProgress !== undefined && typeof onProgress !== 'function') {
    refuse('onProgress', 'a function');
  }
  if (signal !== undefined && typeof signal?.addEventListener !== 'function') {
    refuse('signal', 'an AbortSignal');
  }
  if (signal?.aborted) throw aborted(signal);
  const input = separate(checkMesh(mesh), transfer);
  return submit({
    mesh: input,
    transfer: buffersOf(input),
    build,
    extract,
    check,
    source,
    signal,
    onProgress,
  });
}

function refuse(name: string, expected: string): never {
  throw new KdManifoldError('INVALID_OPTION', `${name}: expected ${expected}`);
}

// Makes arrays that the worker may have: copies, so that the caller may go on changing the originals,
// or, with `transfer`, the originals. Of a large buffer only the part in view is sent.
function separate(mesh: CheckedMesh, transfer: boolean): MeshInput {
  const copy = <T extends CheckedMesh['positions'] | NonNullable<CheckedMesh['indices']>>(
    array: T,
  ): T => {
    const whole = array.byteLength === array.buffer.byteLength && isTransferable(array.buffer);
    return transfer && whole ? array : (array.slice() as T);
  };
  return {
    positions: copy(mesh.positions),
    indices: mesh.indices ? copy(mesh.indices) : null,
    sourceFaces: mesh.sourceFaces ? copy(mesh.sourceFaces) : null,
  };
}

function isTransferable(buffer: ArrayBufferLike): boolean {
  return typeof SharedArrayBuffer !== 'function' || !(buffer instanceof SharedArrayBuffer);
}
