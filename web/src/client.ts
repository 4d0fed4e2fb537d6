// SPDX-License-Identifier: MIT
// The caller's end of the worker. There is one worker; it does one conversion at a time, and the
// others wait in line.
import { convert } from './convert.js';
import { aborted, KdManifoldError } from './errors.js';
import { compile, load, type LoadOptions } from './load.js';
import { openWorker } from './ports.js';
import type { Reply, WorkerPort } from './protocol.js';
import type {
  BuildOptions,
  Conversion,
  ExtractOptions,
  MeshInput,
  ProgressCallback,
} from './types.js';

/** One conversion. Nobody else holds the arrays of its mesh. */
export interface Job {
  mesh: MeshInput;
  transfer: ArrayBuffer[];
  build: BuildOptions;
  extract: ExtractOptions;
  source: LoadOptions;
  signal: AbortSignal | undefined;
  onProgress: ProgressCallback | undefined;
}

// WebAssembly memory never shrinks: a worker that has grown beyond this is not kept for later.
const keptHeapBytes = 256 * 2 ** 20;

// A promise, so that calls at the same time share one start. Undefined: not started, or ended.
let worker: Promise<WorkerPort | null> | undefined;
let line: Promise<unknown> = Promise.resolve();

/** Runs the job after all jobs before it. When its signal aborts, it stops waiting or working. */
export function submit(job: Job): Promise<Conversion> {
  const turn = line.then(() => perform(job));
  line = turn.catch(() => {});
  const { signal } = job;
  if (signal === undefined) return turn;
  return new Promise((resolve, reject) => {
    const stop = (): void => reject(aborted(signal));
    signal.addEventListener('abort', stop, { once: true });
    turn.then(resolve, reject).finally(() => signal.removeEventListener('abort', stop));
  });
}

async function perform(job: Job): Promise<Conversion> {
  if (job.signal?.aborted) throw aborted(job.signal);
  const port = await (worker ??= start(job.source));
  if (job.signal?.aborted) throw aborted(job.signal);
  if (port === null) {
    worker = undefined;
    return performInline(job);
  }
  port.hold(true);
  const conversion = await converse(port, job);
  if (conversion.report.peakBytes > keptHeapBytes) end(port);
  return conversion;
}

// Ends the worker. Only the job at work, or the death of an idle worker, calls this: `port` is always
// the current worker.
function end(port: WorkerPort): void {
  port.listen(
    () => {},
    () => {},
  );
  port.terminate();
  worker = undefined;
}

// Resolves to null if there are no workers here; rejects if the WebAssembly file cannot be loaded.
async function start(source: LoadOptions): Promise<WorkerPort | null> {
  try {
    const module = await compile(source);
    const port = await openWorker();
    if (port === null) return null;
    const ready = await new Promise<boolean>((resolve) => {
      port.listen(
        (reply) => resolve(reply.type === 'ready'),
        () => resolve(false),
      );
      try {
        port.post({ type: 'start', module }, []);
      } catch {
        resolve(false);
      }
    });
    if (ready) rest(port);
    else port.terminate();
    return ready ? port : null;
  } catch (error) {
    worker = undefined;
    throw error;
  }
}

// Puts the worker to rest: between conversions it sends nothing and does not keep Node from ending.
function rest(port: WorkerPort): void {
  port.listen(
    () => {},
    () => end(port),
  );
  port.hold(false);
}

function converse(port: WorkerPort, job: Job): Promise<Conversion> {
  return new Promise<Conversion>((resolve, reject) => {
    // The worker receives nothing while it works: to stop it is to end it.
    const stop = (error: Error): void => {
      job.signal?.removeEventListener('abort', onAbort);
      end(port);
      reject(error);
    };
    const onAbort = (): void => stop(aborted(job.signal));
    const onReply = (reply: Reply): void => {
      if (reply.type === 'progress') {
        try {
          if (job.onProgress?.(reply.fraction, reply.phase) === false) stop(aborted());
        } catch (error) {
          stop(error as Error);
        }
      } else if (reply.type === 'done') {
        job.signal?.removeEventListener('abort', onAbort);
        rest(port);
        resolve(reply.conversion);
      } else if (reply.type === 'failed') {
        const error = new KdManifoldError(reply.code, reply.message);
        // After a bug, or when memory has run out, a new worker is safer.
        if (reply.code === 'INTERNAL' || reply.code === 'OUT_OF_MEMORY') return stop(error);
        job.signal?.removeEventListener('abort', onAbort);
        rest(port);
        reject(error);
      }
    };
    job.signal?.addEventListener('abort', onAbort, { once: true });
    port.listen(onReply, (reason) => {
      stop(
        new KdManifoldError(
          'OUT_OF_MEMORY',
          `the worker died, likely for lack of memory: ${reason}`,
        ),
      );
    });
    port.post(
      { type: 'convert', mesh: job.mesh, build: job.build, extract: job.extract },
      job.transfer,
    );
  });
}

async function performInline(job: Job): Promise<Conversion> {
  const library = await load(job.source);
  return convert(library, job.mesh, job.build, job.extract, (fraction, phase) => {
    if (job.signal?.aborted) return false;
    return job.onProgress?.(fraction, phase);
  });
}
