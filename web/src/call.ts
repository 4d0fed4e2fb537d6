// SPDX-License-Identifier: MIT
// Calls into WebAssembly: every way in which they can fail becomes a KdManifoldError.
import { KdManifoldError } from './errors.js';
import type { Answer, RawProgress } from './kdmanifold.js';
import type { ProgressCallback } from './types.js';

/** Whether the WebAssembly instance can be trusted; shared by all that call into it. */
export interface Health {
  broken: boolean;
}

/**
 * Makes the call and unwraps its answer. Exceptions of the callback must not pass through C++, so
 * they are kept, the call is stopped, and they are thrown again afterwards.
 */
export function call<T>(
  health: Health,
  onProgress: ProgressCallback | undefined,
  work: (progress: RawProgress) => Answer<T>,
): T {
  if (onProgress !== undefined && typeof onProgress !== 'function') {
    throw new KdManifoldError('INVALID_OPTION', 'onProgress: expected a function');
  }
  let thrown: { error: unknown } | null = null;
  const progress: RawProgress = onProgress
    ? (fraction, phase) => {
        try {
          return onProgress(fraction, phase) !== false;
        } catch (error) {
          thrown = { error };
          return false;
        }
      }
    : null;
  const answer = attempt(health, () => work(progress));
  if (thrown !== null) throw (thrown as { error: unknown }).error;
  if (answer.code !== undefined)
    throw new KdManifoldError(answer.code, inJavaScript(answer.message));
  return answer.value;
}

// C++ exceptions come back as answers. What is thrown is either memory that JavaScript could not
// get for the copy of a result, or a trap of the engine, after which the instance is not to be used
// again: `load` then makes another.
function attempt<T>(health: Health, work: () => T): T {
  try {
    return work();
  } catch (error) {
    if (error instanceof RangeError && /alloc|array length/i.test(error.message)) {
      throw new KdManifoldError('OUT_OF_MEMORY', 'not enough memory for the result', {
        cause: error,
      });
    }
    health.broken = true;
    throw new KdManifoldError('INTERNAL', `WebAssembly stopped: ${String(error)}; load it again`, {
      cause: error,
    });
  }
}

// C++ puts names of options in backticks, and writes them its own way.
const inJavaScript = (message: string): string =>
  message.replace(/`[a-z]+(_[a-z]+)+`/g, (name) =>
    name.replace(/_./g, (pair) => pair.charAt(1).toUpperCase()),
  );
