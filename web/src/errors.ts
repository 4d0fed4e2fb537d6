// SPDX-License-Identifier: MIT
// The one error type of the package.
import type { Signal } from './outside-types.js';

/**
 * What went wrong:
 * - `INVALID_MESH`: an array is unusable; the message names it, the index and the value
 * - `INVALID_OPTION`: an option is unknown or out of its range
 * - `NOT_CLOSED`: the input encloses nothing, has a hole wider than `largestHole`, or is open or
 *   inconsistently oriented where the inside rule wants it closed
 * - `EMPTY_RESULT`: nothing of the surface is left at this tolerance or depth
 * - `PARSE_ERROR`: a file's content is malformed; the message names line, byte or rule
 * - `IO_ERROR`: a file cannot be read or written, or its extension is unknown
 * - `OUT_OF_MEMORY`: the 4 GB that WebAssembly has, or what the machine gives, were not enough
 * - `ABORTED`: the signal or the progress callback asked to stop
 * - `DELETED`: a grid was used after `delete()`
 * - `LOAD_FAILED`: the WebAssembly file could not be fetched or compiled
 * - `INTERNAL`: a bug of this library, please report it
 */
export type ErrorCode =
  | 'INVALID_MESH'
  | 'INVALID_OPTION'
  | 'NOT_CLOSED'
  | 'EMPTY_RESULT'
  | 'PARSE_ERROR'
  | 'IO_ERROR'
  | 'OUT_OF_MEMORY'
  | 'ABORTED'
  | 'DELETED'
  | 'LOAD_FAILED'
  | 'INTERNAL';

/** Thrown, or rejected with, by everything in this package; the module works on afterwards. */
export class KdManifoldError extends Error {
  /** What went wrong, for programs. The message says it for people. */
  readonly code: ErrorCode;

  constructor(code: ErrorCode, message: string, options?: { cause?: unknown }) {
    super(message, options);
    this.name = 'KdManifoldError';
    this.code = code;
  }
}

/**
 * @internal What to reject with when a signal was aborted: the reason that it was given. Where it was given none the
 * platform made an `AbortError`, and this library's own error says it instead.
 */
export function aborted(): KdManifoldError;
export function aborted(signal: Signal | undefined): unknown;
export function aborted(signal?: Signal): unknown {
  const reason = signal?.reason;
  const given = reason !== undefined && !isDefaultReason(reason);
  return given ? reason : new KdManifoldError('ABORTED', 'stopped on request', { cause: reason });
}

const isDefaultReason = (reason: unknown): boolean =>
  Object.prototype.toString.call(reason) === '[object DOMException]' &&
  (reason as { name: string }).name === 'AbortError';
