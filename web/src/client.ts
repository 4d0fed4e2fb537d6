// SPDX-License-Identifier: MIT
// The caller's end of the worker: one worker, one conversion at a time, the others wait in line.
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

/** One conversion, its mesh no longer shared with anybody. */
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

/** Runs the job when those before it are done; stops waiting or working when its signal says so. */
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

// Only the job in work or an idle worker's own death calls this, so it is the worker of the moment.
function end(port: WorkerPort): void {
  port.listen(
    () => {},
    () => {},
  );
  port.terminate();
  worker = undefined;
}

// Null if workers cannot be had here; an error if the WebAssembly file itself is not to be had.
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

// Between conversions the worker neither speaks nor keeps Node from ending.
function rest(port: WorkerPort): void {
  port.listen(
    () => {},
    () => end(port),
  );
  port.hold(false);
}

function converse(port: WorkerPort, job: Job): Promise<Conversion> {
  return new Promise<Conversion>((resolve, reject) => {
    // The worker is deaf while it works: stopping it means ending it.
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
        // After a bug or at the end of memory a fresh start is safer.
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
