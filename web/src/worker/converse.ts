// SPDX-License-Identifier: MIT
// One conversion by a worker, as the caller's end sees it.
import { aborted, KdManifoldError } from '../errors.js';
import type { Outcome } from '../convert.js';
import type { Job } from './pool.js';
import type { Reply, WorkerPort } from './protocol.js';

/** A conversion that is under way. */
export interface Talk {
  outcome: Promise<Outcome>;
  /** Lets the outcome be this failure; the worker must be ended then. */
  stop: (reason: unknown) => void;
  /** Whether the worker is fit for another conversion after this one has failed. */
  fit: () => boolean;
}

/** Sends the job to the worker and hears its replies. */
export function converse(port: WorkerPort, job: Job): Talk {
  let fit = false; // The worker receives nothing while it works: to stop it is to end it.
  let stop: (reason: unknown) => void = () => {};
  const outcome = new Promise<Outcome>((resolve, reject) => {
    stop = reject;
    const onReply = (reply: Reply): void => {
      if (reply.type === 'progress') {
        try {
          if (job.onProgress?.(reply.fraction, reply.phase) === false) reject(aborted());
        } catch (error) {
          reject(error);
        }
      } else if (reply.type === 'done') {
        resolve(reply.outcome);
      } else if (reply.type === 'failed') {
        // After a bug, or when memory has run out, a new worker is safer.
        fit = reply.code !== 'INTERNAL' && reply.code !== 'OUT_OF_MEMORY';
        reject(new KdManifoldError(reply.code, reply.message));
      }
    };
    port.listen(onReply, (reason) => {
      reject(
        new KdManifoldError(
          'OUT_OF_MEMORY',
          `the worker died, likely for lack of memory: ${reason}`,
        ),
      );
    });
    port.post({ type: 'order', order: job.order }, job.transfer);
  });
  return { outcome, stop, fit: () => fit };
}
