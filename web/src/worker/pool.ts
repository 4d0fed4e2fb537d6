// SPDX-License-Identifier: MIT
// The workers, and the line of conversions before them. Each worker does one at a time; how many work at
// a time is `concurrency`; all others wait in line.
import { fulfil, type Order, type Outcome } from '../convert.js';
import { textOf } from '../environment.js';
import { aborted, KdManifoldError } from '../errors.js';
import { loadMain, unload } from '../load.js';
import type { Source } from '../load-options.js';
import type { Signal } from '../outside-types.js';
import { threadsFor } from '../threads/count.js';
import type { Conversion, ProgressCallback, Simplification } from '../types.js';
import { converse } from './converse.js';
import type { WorkerPort } from './protocol.js';
import { start } from './start.js';

/** One conversion. Nobody else holds the arrays of its meshes. */
export interface Job {
  order: Order;
  transfer: ArrayBuffer[];
  source: Source;
  signal: Signal | undefined;
  onProgress: ProgressCallback | undefined;
}

/** A job that somebody waits for. */
interface Task {
  job: Job;
  resolve: (outcome: Outcome) => void;
  reject: (reason: unknown) => void;
  /** Whether nobody waits any more. */
  settled: boolean;
  /** Stops it; only while a worker is at it. */
  stop?: (reason: unknown) => void;
}

// WebAssembly memory never shrinks: a worker that has grown beyond this is not kept for later.
const keptHeapBytes = 256 * 2 ** 20;

/** A worker, ready or still starting; null: it could not be started. */
interface Seat {
  port: Promise<WorkerPort | null>;
  /** What the caller said of it: `workerUrl` or `worker`. */
  origin: unknown;
  /** How many threads it was to have. */
  threads: number;
}

/** Workers without work. */
let spare: Seat[] = [];
const waiting: Task[] = [];
const working = new Set<Task>();
/** The last words of workers that are being ended. */
let ends: Promise<void>[] = [];
let warned = false;

/** Runs the job as soon as its turn has come. When its signal aborts, it stops waiting or working. */
export function submit(job: Job & { order: { type: 'convert' } }): Promise<Conversion>;
export function submit(job: Job & { order: { type: 'simplify' } }): Promise<Simplification>;
export function submit(job: Job): Promise<Outcome> {
  return new Promise((resolve, reject) => {
    const settle =
      <T>(act: (value: T) => void) =>
      (value: T): void => {
        task.settled = true;
        job.signal?.removeEventListener('abort', onAbort);
        act(value);
      };
    const task: Task = { job, resolve: settle(resolve), reject: settle(reject), settled: false };
    const onAbort = (): void => cancel(task, aborted(job.signal));
    job.signal?.addEventListener('abort', onAbort);
    waiting.push(task);
    pump();
  });
}

/** Starts workers ahead of the first conversion, so that it need not wait for them. */
export async function warmUp(source: Source): Promise<void> {
  if (source.worker === false) {
    await loadMain(source);
    return;
  }
  const threads = await threadsFor(source);
  const fit = (seat: Seat): boolean => suits(seat, source, threads);
  while (spare.filter(fit).length + working.size < source.concurrency) {
    keep(launch(source, threads));
  }
  const ports = await Promise.all(spare.map(({ port }) => port));
  if (ports.includes(null)) await loadMain(source);
}

/** Ends all workers and forgets the module. What is at work or in line rejects with `ABORTED`. */
export async function shutDown(): Promise<void> {
  const closed = (): KdManifoldError => new KdManifoldError('ABORTED', 'stopped by close()');
  for (const task of [...waiting, ...working]) cancel(task, closed());
  const ports = await Promise.allSettled(spare.splice(0).map(({ port }) => port));
  for (const port of ports) if (port.status === 'fulfilled' && port.value) end(port.value);
  unload();
  warned = false;
  await Promise.all(ends.splice(0));
}

function cancel(task: Task, reason: unknown): void {
  const place = waiting.indexOf(task);
  if (place >= 0) waiting.splice(place, 1);
  task.stop?.(reason);
  if (!task.settled) task.reject(reason);
  pump();
}

function pump(): void {
  while (waiting.length > 0 && working.size < (waiting[0] as Task).job.source.concurrency) {
    const task = waiting.shift() as Task;
    working.add(task);
    void perform(task).finally(() => {
      working.delete(task);
      pump();
    });
  }
}

async function perform(task: Task): Promise<void> {
  const { job } = task;
  try {
    const seat = job.source.worker === false ? null : await sit(job.source);
    const port = await seat?.port;
    if (task.settled) {
      if (seat && port) keep(seat);
    } else if (seat && port) {
      await performInWorker(task, seat, port);
    } else {
      task.resolve(await performHere(job));
    }
  } catch (error) {
    if (!task.settled) task.reject(error);
  }
}

async function performInWorker(task: Task, seat: Seat, port: WorkerPort): Promise<void> {
  port.hold(true);
  const talk = converse(port, task.job);
  task.stop = talk.stop;
  try {
    const outcome = await talk.outcome;
    if (outcome.report.peakBytes > keptHeapBytes) end(port);
    else keep(seat);
    task.resolve(outcome);
  } catch (error) {
    if (talk.fit()) keep(seat);
    else end(port);
    throw error;
  } finally {
    delete task.stop;
  }
}

async function performHere(job: Job): Promise<Outcome> {
  const library = await loadMain(job.source);
  return fulfil(library, job.order, (fraction, phase) => {
    if (job.signal?.aborted) return false;
    return job.onProgress?.(fraction, phase);
  });
}

/** What a caller said of the worker; undefined: nothing. */
const originOf = ({ worker, workerUrl }: Source): unknown =>
  worker ?? (workerUrl && textOf(workerUrl));

/** Says whether the worker is one that the caller would have: of those it did not speak of, any will do. */
function suits(seat: Seat, source: Source, threads: number): boolean {
  const wanted = originOf(source);
  return threads === seat.threads && (wanted === undefined || wanted === seat.origin);
}

/** Takes a worker that suits, or starts one. */
async function sit(source: Source): Promise<Seat> {
  const threads = await threadsFor(source);
  const seat = spare.find((other) => suits(other, source, threads));
  spare = spare.filter((other) => other !== seat);
  return seat ?? launch(source, threads);
}

function launch(source: Source, threads: number): Seat {
  return { origin: originOf(source), threads, port: openWith(source, threads) };
}

/** Starts a worker outside of the line; null: none can be started, which is told once. */
export const open = async (source: Source): Promise<WorkerPort | null> =>
  openWith(source, await threadsFor(source));

async function openWith(source: Source, threads: number): Promise<WorkerPort | null> {
  const started = await start(source, threads);
  if ('port' in started) return started.port;
  if (!warned) {
    warned = true;
    console.warn(
      `kdmanifold: no worker could be started (${started.reason}). The calling thread does the work ` +
        `and can do nothing else meanwhile. Copy node_modules/kdmanifold/dist/kdmanifold-worker.js ` +
        `to where the page looks for it, or see the options workerUrl and worker; ` +
        `worker: false says that this is meant.`,
    );
  }
  return null;
}

/** Lays a worker, or one that is starting, by for the next conversion. */
function keep(seat: Seat): void {
  spare.push(seat);
  const forget = (): void => {
    spare = spare.filter((other) => other !== seat);
  };
  seat.port.then((port) => {
    // Taken meanwhile, or gone: whoever took it listens to it.
    if (port === null) return forget();
    if (!spare.includes(seat)) return;
    // Between conversions it sends nothing, does not keep Node from ending, and may die unnoticed.
    port.listen(ignore, () => (forget(), end(port)));
    port.hold(false);
  }, forget);
}

const ignore = (): void => {};

/** Ends a worker. `shutDown` waits for that. */
export function end(port: WorkerPort): void {
  port.listen(ignore, ignore);
  const gone = port.terminate();
  ends.push(gone);
  void gone.finally(() => (ends = ends.filter((other) => other !== gone)));
}
