// SPDX-License-Identifier: MIT
// What all calls that work in a worker are told, and the copies of a mesh that a worker may have.
import type { CheckedMesh } from './check-input.js';
import { aborted, KdManifoldError } from './errors.js';
import { checkSource, sourceKeys, type LoadOptions, type WorkerOptions } from './load-options.js';
import type { Signal } from './outside-types.js';
import type { ProgressOptions } from './types.js';
import type { Job } from './worker/pool.js';

/** Where to work, how to be told and stopped. */
export interface JobOptions extends ProgressOptions, LoadOptions, WorkerOptions {
  /**
   * Stops the work, which then rejects with the reason that the signal was given; where it was given none, with
   * `ABORTED`.
   */
  signal?: Signal;
  /** Hand the mesh's arrays over instead of copying them; they are empty afterwards. */
  transfer?: boolean;
}

/** @internal The names of these options. */
export const jobKeys = ['onProgress', 'signal', 'transfer', ...sourceKeys];

/** @internal Refuses an option. */
export function refuse(name: string, expected: string): never {
  throw new KdManifoldError('INVALID_OPTION', `${name}: expected ${expected}`);
}

/** @internal Checks these options, and returns the job, still without its order and what goes with it. */
export function jobOf(options: JobOptions): Omit<Job, 'order' | 'transfer'> {
  const { onProgress, signal, transfer = false } = options;
  const source = checkSource(options);
  if (typeof transfer !== 'boolean') refuse('transfer', 'true or false');
  if (onProgress !== undefined && typeof onProgress !== 'function') {
    refuse('onProgress', 'a function');
  }
  if (signal !== undefined && typeof signal?.addEventListener !== 'function') {
    refuse('signal', 'an AbortSignal');
  }
  if (signal?.aborted) throw aborted(signal);
  return { source, signal, onProgress };
}

/**
 * @internal Makes a mesh of arrays that the worker may have: copies, so that the caller may go on changing the originals,
 * or, with `transfer`, the originals. Of a large buffer only the part in view is sent.
 */
export function ownMesh(
  mesh: CheckedMesh,
  { transfer = false }: JobOptions,
): Pick<CheckedMesh, 'positions' | 'indices' | 'sourceFaces'> {
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
